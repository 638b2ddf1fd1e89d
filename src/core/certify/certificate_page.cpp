#include <algorithm>
#include <string>
#include <string_view>

#include "core/base/version.h"
#include "core/certify/certificate.h"
#include "core/certify/check_text.h"

namespace planewright {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

constexpr std::string_view kStyle = R"(
:root { --ink: #1d2126; --soft: #626b75; --line: #dfe3e7; --ground: #fff; --pass: #1f6b45; --fail: #a8241c; --fail-ground: #fdf3f2; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 48px 40px 64px; max-width: 62rem; background: var(--ground); color: var(--ink);
  font: 15px/1.5 Inter, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; font-variant-numeric: tabular-nums; }
header { border-top: 6px solid var(--pass); padding-top: 20px; margin-bottom: 40px; }
header.fail { border-color: var(--fail); }
.kind { margin: 0; color: var(--soft); font-size: 13px; letter-spacing: .04em; }
h1 { margin: 2px 0 18px; font-size: 30px; line-height: 1.2; font-weight: 600; overflow-wrap: anywhere; }
.verdict { margin: 0; font-size: 22px; font-weight: 600; color: var(--pass); }
.fail .verdict { color: var(--fail); }
.meaning { margin: 4px 0 0; max-width: 46rem; color: var(--soft); }
dl { display: flex; flex-wrap: wrap; gap: 12px 40px; margin: 24px 0 0; }
dt { color: var(--soft); font-size: 13px; }
dd { margin: 0; font-size: 18px; font-weight: 600; }
h2 { margin: 40px 0 4px; font-size: 19px; font-weight: 600; break-after: avoid; }
section { margin-top: 28px; }
h3 { display: flex; align-items: baseline; gap: 12px; margin: 0; padding-bottom: 6px; border-bottom: 1px solid var(--ink);
  font-size: 15px; font-weight: 600; break-after: avoid; }
h3 .file { overflow-wrap: anywhere; }
h3 .reader { margin-left: auto; color: var(--soft); font-weight: 400; font-size: 13px; text-align: right; }
table { width: 100%; border-collapse: collapse; }
td { padding: 5px 12px 5px 0; vertical-align: top; border-bottom: 1px solid var(--line); }
tr { break-inside: avoid; }
td.mark { width: 4.2rem; font-weight: 600; color: var(--pass); }
td.name { width: 15rem; }
td.detail { color: var(--soft); overflow-wrap: anywhere; padding-right: 0; }
tr.fail td { background: var(--fail-ground); }
tr.fail td.mark, tr.fail td.name { color: var(--fail); font-weight: 600; }
tr.fail td.mark { padding-left: 8px; }
tr.fail td.detail { color: var(--ink); }
footer { margin-top: 48px; color: var(--soft); font-size: 13px; }
@media (max-width: 640px) { body { padding: 24px 16px; } td.name { width: 9rem; } h3 { flex-wrap: wrap; } h3 .reader { margin-left: 0; } }
@page { size: A4; margin: 18mm 16mm; }
@media print { body { max-width: none; padding: 0; font-size: 9.5pt; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  h1 { font-size: 20pt; } .verdict { font-size: 15pt; } h2 { font-size: 13pt; } h3 { font-size: 10pt; } dd { font-size: 12pt; } }
)";

void append_rows(std::string& out, const std::vector<Check>& checks, const std::string& before = {}) {
  for (const Check& c : checks) {
    out += c.pass ? "<tr>" : "<tr class=\"fail\">";
    out += std::string("<td class=\"mark\">") + (c.pass ? "Pass" : "Fail") + "</td><td class=\"name\">" +
           escaped(before + c.name) + "</td><td class=\"detail\">" + escaped(c.detail) + "</td></tr>\n";
  }
}

void append_section(std::string& out, const std::string& title, const std::string& reader,
                    const std::vector<Check>& checks) {
  out += "<section><h3><span class=\"file\">" + escaped(title) + "</span>";
  if (!reader.empty()) out += "<span class=\"reader\">read by " + escaped(reader) + "</span>";
  out += "</h3>\n<table>\n";
  append_rows(out, checks);
  out += "</table></section>\n";
}

std::vector<Check> failing(const std::vector<Check>& checks) {
  std::vector<Check> some;
  std::copy_if(checks.begin(), checks.end(), std::back_inserter(some),
               [](const Check& c) { return !c.pass; });
  return some;
}

void append_number(std::string& out, std::string_view what, const std::string& value) {
  out += "<div><dt>" + std::string(what) + "</dt><dd>" + value + "</dd></div>";
}

void append_head(std::string& out, const Certificate& certificate, const ExportContent& content) {
  size_t checks = certificate.design.size(), failed = failing(certificate.design).size(), files = 0;
  for (const FileCertificate& f : certificate.files) {
    checks += f.checks.size();
    failed += failing(f.checks).size();
    files += f.file.starts_with("all ") ? 0 : 1;
  }
  const bool pass = certificate.pass();
  const auto number = [](auto n) { return counted(static_cast<long long>(n)); };
  out += pass ? "<header>" : "<header class=\"fail\">";
  out += "<p class=\"kind\">Certificate of an export</p><h1>" +
         escaped(content.model->title.empty() ? "Untitled" : content.model->title) + "</h1>";
  out += "<p class=\"verdict\">" +
         (pass ? "PASS: " + number(checks) + " checks hold"
               : "FAIL: " + number(failed) + " of " + number(checks) + " checks do not hold") +
         "</p>";
  out +=
      pass ? "<p class=\"meaning\">Every file was read back by a reader that is not its writer, and says "
             "what the "
             "design says.</p>"
           : "<p class=\"meaning\">Do not cut from these files before the failures below are understood.</p>";
  out += "<dl>";
  append_number(out, "Panels", number(content.model->panel_count()));
  append_number(out, "Within tolerances", number(content.verdicts->passed));
  append_number(out, "Beyond tolerances", number(content.verdicts->failed));
  append_number(out, "Left out of the drawings", number(content.left_out.size()));
  append_number(out, "Files", number(files));
  out += "</dl></header>\n";
}

void append_failures(std::string& out, const Certificate& certificate) {
  if (certificate.pass()) return;
  out += "<h2>What fails</h2>\n<section><table>\n";
  append_rows(out, failing(certificate.design), "Design: ");
  for (const FileCertificate& f : certificate.files) append_rows(out, failing(f.checks), f.file + ": ");
  out += "</table></section>\n";
}

}  // namespace

std::string certificate_page(const Certificate& certificate, const ExportContent& content) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      std::string(certificate.pass() ? "PASS" : "FAIL") + ": certificate of " +
      escaped(content.model->title) + "</title>\n<style>" + std::string(kStyle) +
      "</style>\n</head>\n<body>\n";
  append_head(out, certificate, content);
  append_failures(out, certificate);
  if (!content.left_out.empty()) {
    std::string names;
    for (const int p : content.left_out)
      names += (names.empty() ? "" : ", ") + content.model->names[static_cast<size_t>(p)];
    out += "<h2>Left out of the drawings</h2>\n<p>" + escaped(names) + "</p>\n";
  }
  out += "<h2>Design</h2>\n";
  append_section(out, "Panels, patterns and solids", {}, certificate.design);
  out += "<h2>Files</h2>\n";
  for (const FileCertificate& f : certificate.files) append_section(out, f.file, f.reader, f.checks);
  out += "<footer>Planewright " + escaped(kVersion) +
         ". Lengths in millimetres. Signs (crossings, orientation, volumes) are decided exactly, without "
         "rounding.</footer>\n</body>\n</html>\n";
  return out;
}

}  // namespace planewright
