// What an earlier export left in a folder: so that one that takes its place leaves none of its sheets behind.
// Threads: pure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace planewright {

// Names of the certificate's files, below the folder of an export.
inline constexpr const char* kCertificateJson = "certificate.json";
inline constexpr const char* kCertificatePage = "certificate.html";

// The files below `folder` that a certificate there lists, and the certificate itself; only those that are
// there and lie below the folder. Nothing if there is none, or it is none of ours.
std::vector<std::string> files_of_earlier_export(const std::filesystem::path& folder);

}  // namespace planewright
