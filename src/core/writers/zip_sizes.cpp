#include "core/writers/zip_sizes.h"

#include <cstdint>

namespace planewright {
namespace {

// Headers of the zip format (PKWARE's APPNOTE, 4.3.7 and 4.3.12); numbers are little-endian.
constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kMoved = 0xffffffff;
constexpr std::size_t kLocalBytes = 30, kCentralBytes = 46, kExtraHead = 4;

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number value = 0;
  for (std::size_t k = 0; k < sizeof(Number) && at + k < bytes.size(); ++k)
    value |= static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(bytes[at + k])) << (8 * k));
  return value;
}

// Takes the number out of the zip64 field where `at` says that it went there; moves on in the field.
void put_back(std::string& bytes, std::size_t at, std::size_t& in_field) {
  if (number_at<std::uint32_t>(bytes, at) != kMoved) return;
  const std::uint64_t value = number_at<std::uint64_t>(bytes, in_field);
  in_field += 8;
  if (value >= kMoved) return;
  for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(value >> (8 * k) & 0xff);
}

}  // namespace

std::string with_plain_sizes(std::string package) {
  std::size_t at = 0;
  while (number_at<std::uint32_t>(package, at) == kLocal) {
    const std::size_t name = number_at<std::uint16_t>(package, at + 26),
                      extra = number_at<std::uint16_t>(package, at + 28);
    std::size_t field = at + kLocalBytes + name + kExtraHead;
    put_back(package, at + 22, field);  // as it is, then packed: the order of the field
    const std::size_t sizes = field;
    put_back(package, at + 18, field);
    const std::uint64_t packed =
        field > sizes ? number_at<std::uint64_t>(package, sizes) : number_at<std::uint32_t>(package, at + 18);
    at += kLocalBytes + name + extra + static_cast<std::size_t>(packed);
  }
  while (number_at<std::uint32_t>(package, at) == kCentral) {
    const std::size_t name = number_at<std::uint16_t>(package, at + 28),
                      extra = number_at<std::uint16_t>(package, at + 30),
                      comment = number_at<std::uint16_t>(package, at + 32);
    std::size_t field = at + kCentralBytes + name + kExtraHead;
    put_back(package, at + 24, field);
    put_back(package, at + 20, field);
    put_back(package, at + 42, field);
    at += kCentralBytes + name + extra + comment;
  }
  return package;
}

}  // namespace planewright
