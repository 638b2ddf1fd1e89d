#include "core/certify/package_info.h"

#include <libxml/xmlreader.h>
#include <minizip/unzip.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace planewright {
namespace {

struct ClosePackage {
  void operator()(void* package) const { unzClose(package); }
};
struct FreeReader {
  void operator()(xmlTextReader* reader) const { xmlFreeTextReader(reader); }
};
struct FreeText {
  void operator()(xmlChar* text) const { xmlFree(text); }
};

// The bytes of the entry that minizip stands at; nothing if they do not unpack.
std::optional<std::string> unpacked(unzFile package) {
  if (unzOpenCurrentFile(package) != UNZ_OK) return {};
  std::string bytes;
  std::string buffer(1 << 16, '\0');
  int got = 0;
  while ((got = unzReadCurrentFile(package, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0)
    bytes.append(buffer.data(), static_cast<size_t>(got));
  const bool sound = unzCloseCurrentFile(package) == UNZ_OK;  // checks the sum
  if (got < 0 || !sound) return {};
  return bytes;
}

std::optional<std::string> attribute(xmlTextReader* reader, const char* name) {
  const std::unique_ptr<xmlChar, FreeText> text(
      xmlTextReaderGetAttribute(reader, reinterpret_cast<const xmlChar*>(name)));
  if (!text) return {};
  return std::string(reinterpret_cast<const char*>(text.get()));
}

// Nothing: the model is no XML, or breaks off.
std::optional<PackageInfo> scanned(const std::string& model) {
  const std::unique_ptr<xmlTextReader, FreeReader> reader(
      xmlReaderForMemory(model.data(), static_cast<int>(model.size()), nullptr, nullptr,
                         XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE));
  if (!reader) return {};
  PackageInfo info;
  int read = 0;
  while ((read = xmlTextReaderRead(reader.get())) == 1) {
    if (xmlTextReaderNodeType(reader.get()) != XML_READER_TYPE_ELEMENT) continue;
    const std::string_view element = reinterpret_cast<const char*>(xmlTextReaderConstLocalName(reader.get()));
    if (element == "model") {
      info.unit = attribute(reader.get(), "unit").value_or(info.unit);
    } else if (element == "object") {
      info.names[attribute(reader.get(), "id").value_or("")] = attribute(reader.get(), "name").value_or("");
    }
  }
  if (read != 0) return {};
  return info;
}

}  // namespace

Result<PackageInfo> read_package(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::unique_ptr<void, ClosePackage> package(unzOpen64(path.c_str()));
  if (!package) return fail(ErrorCode::Unreadable, "it is no package", name);
  for (int at = unzGoToFirstFile(package.get()); at == UNZ_OK; at = unzGoToNextFile(package.get())) {
    std::string entry(512, '\0');
    if (unzGetCurrentFileInfo64(package.get(), nullptr, entry.data(), entry.size() - 1, nullptr, 0, nullptr,
                                0) != UNZ_OK)
      break;
    entry.resize(entry.find('\0'));
    if (!entry.ends_with(".model")) continue;
    const auto bytes = unpacked(package.get());
    if (!bytes) return fail(ErrorCode::Unreadable, "its model does not unpack", name);
    auto info = scanned(*bytes);
    if (!info) return fail(ErrorCode::Unreadable, "its model is no XML", name);
    return std::move(*info);
  }
  return fail(ErrorCode::Unreadable, "no model in the package", name);
}

}  // namespace planewright
