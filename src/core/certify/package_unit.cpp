#include "core/certify/package_unit.h"

#include <libxml/xmlreader.h>
#include <minizip/unzip.h>

#include <memory>
#include <optional>

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

}  // namespace

Result<std::string> package_unit(const std::filesystem::path& path) {
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
    const std::unique_ptr<xmlTextReader, FreeReader> reader(
        xmlReaderForMemory(bytes->data(), static_cast<int>(bytes->size()), entry.c_str(), nullptr,
                           XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE));
    while (reader && xmlTextReaderRead(reader.get()) == 1) {
      if (xmlTextReaderNodeType(reader.get()) != XML_READER_TYPE_ELEMENT) continue;
      const std::unique_ptr<xmlChar, FreeText> unit(
          xmlTextReaderGetAttribute(reader.get(), reinterpret_cast<const xmlChar*>("unit")));
      return unit ? std::string(reinterpret_cast<const char*>(unit.get())) : std::string("millimeter");
    }
    return fail(ErrorCode::Unreadable, "its model is no XML", name);
  }
  return fail(ErrorCode::Unreadable, "no model in the package", name);
}

}  // namespace planewright
