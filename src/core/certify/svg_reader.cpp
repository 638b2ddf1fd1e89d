#include "core/certify/svg_reader.h"

#include <libxml/parser.h>
#include <libxml/tree.h>
#include <libxml/xmlversion.h>

#include <cmath>
#include <memory>

#include "core/certify/file_bytes.h"
#include "core/certify/svg_numbers.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

struct FreeDocument {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
struct FreeText {
  void operator()(xmlChar* text) const { xmlFree(text); }
};

std::string text_of(xmlChar* owned) {
  const std::unique_ptr<xmlChar, FreeText> text(owned);
  return text ? std::string(reinterpret_cast<const char*>(text.get())) : std::string();
}
// By its local name, whatever its namespace: "label" of inkscape:label.
std::optional<std::string> attribute(const xmlNode* node, std::string_view name) {
  for (const xmlAttr* a = node->properties; a; a = a->next)
    if (name == reinterpret_cast<const char*>(a->name))
      return text_of(xmlNodeListGetString(node->doc, a->children, 1));
  return {};
}
std::string_view tag(const xmlNode* node) {
  return reinterpret_cast<const char*>(node->name);
}

// What an element has from the groups around it.
struct Around {
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  std::string layer, panel;
};

class Reader {
 public:
  explicit Reader(std::string name) : name_(std::move(name)) {}

  Result<ReadDrawing> read(const xmlNode* root) {
    if (tag(root) != "svg")
      return error("the outermost element is '" + std::string(tag(root)) + "', not svg", root);
    Around around;
    if (auto framed = frame(root, around); !framed) return tl::unexpected(framed.error());
    if (auto done = children(root, around); !done) return tl::unexpected(done.error());
    return std::move(drawing_);
  }

 private:
  tl::unexpected<Error> error(std::string what, const xmlNode* node) const {
    return fail(ErrorCode::Unreadable, std::move(what), name_ + ":" + std::to_string(xmlGetLineNo(node)));
  }

  // Millimetres per unit of the viewBox, and y up.
  Result<void> frame(const xmlNode* root, Around& around) {
    const std::string width_text = attribute(root, "width").value_or("");
    const std::string height_text = attribute(root, "height").value_or("");
    const auto width = svg_length(width_text), height = svg_length(height_text);
    if (!width || !height || *width <= 0.0 || *height <= 0.0)
      return error("width and height are no lengths", root);
    std::vector<double> box{0.0, 0.0, *width * 96.0 / 25.4, *height * 96.0 / 25.4};
    const auto box_text = attribute(root, "viewBox");
    if (box_text) {
      const auto values = svg_numbers(*box_text);
      if (!values || values->size() != 4 || (*values)[2] <= 0.0 || (*values)[3] <= 0.0)
        return error("'" + *box_text + "' is no viewBox", root);
      box = *values;
    }
    const double x = *width / box[2], y = *height / box[3];
    if (std::abs(x / y - 1.0) > 1e-9) return error("the scale of viewBox differs between x and y", root);
    drawing_.unit =
        "width " + width_text + ", height " + height_text + ", viewBox " + box_text.value_or("none");
    drawing_.mm_per_unit = x;
    drawing_.size = Vector2d(*width, *height);
    around.transform.matrix() << x, 0.0, -x * box[0], 0.0, -y, y * (box[1] + box[3]), 0.0, 0.0, 1.0;
    return {};
  }

  Result<void> children(const xmlNode* parent, const Around& around) {
    for (const xmlNode* node = parent->children; node; node = node->next) {
      if (node->type != XML_ELEMENT_NODE) continue;
      if (auto done = element(node, around); !done) return done;
    }
    return {};
  }

  Result<void> element(const xmlNode* node, Around around) {
    const std::string_view kind = tag(node);
    if (kind == "defs" || kind == "metadata" || kind == "title" || kind == "desc" || kind == "style" ||
        kind == "namedview")
      return {};
    if (const auto text = attribute(node, "transform")) {
      const auto t = svg_transform(*text);
      if (!t) return error("'" + *text + "' is no transform that we know", node);
      around.transform = around.transform * *t;
    }
    if (const auto panel = attribute(node, "data-panel")) around.panel = *panel;
    if (kind == "g") {
      if (attribute(node, "groupmode") == "layer") {
        around.layer = attribute(node, "label").value_or(attribute(node, "id").value_or(""));
        drawing_.layers.push_back(around.layer);
      }
      return children(node, around);
    }
    if (kind == "text") return text(node, around);
    if (kind == "polygon" || kind == "polyline") return poly(node, around, kind == "polygon");
    if (kind == "path") return path(node, around);
    if (kind == "line") return line(node, around);
    if (kind == "rect") return rect(node, around);
    return error("an element '" + std::string(kind) + "', which no drawing for cutting has", node);
  }

  void add(const Around& around, std::vector<Vector2d> points, bool closed) {
    // An open line that comes back to where it began (a stroke of an engraved 0) is none that is closed.
    if (closed && points.size() > 2 && points.front() == points.back()) points.pop_back();
    ReadLine read{around.layer, around.panel, Contour(static_cast<Eigen::Index>(points.size()), 2), closed};
    for (size_t i = 0; i < points.size(); ++i)
      read.points.row(static_cast<Eigen::Index>(i)) = around.transform * points[i];
    drawing_.lines.push_back(std::move(read));
  }

  Result<void> poly(const xmlNode* node, const Around& around, bool closed) {
    const auto values = svg_numbers(attribute(node, "points").value_or(""));
    if (!values || values->empty() || values->size() % 2 != 0) return error("points that are none", node);
    std::vector<Vector2d> points;
    for (size_t i = 0; i + 1 < values->size(); i += 2) points.emplace_back((*values)[i], (*values)[i + 1]);
    add(around, std::move(points), closed);
    return {};
  }
  Result<void> path(const xmlNode* node, const Around& around) {
    const auto pieces = svg_path(attribute(node, "d").value_or(""));
    if (!pieces || pieces->empty()) return error("a path with curves, or none", node);
    for (const SvgPiece& piece : *pieces) add(around, piece.points, piece.closed);
    return {};
  }
  // Attributes that are numbers in user units; absent: 0.
  Result<double> coordinate(const xmlNode* node, std::string_view name) const {
    const auto text = attribute(node, name);
    if (!text) return 0.0;
    const auto values = svg_numbers(*text);
    if (!values || values->size() != 1)
      return error(std::string(name) + " '" + *text + "' is no number", node);
    return values->front();
  }
  Result<void> line(const xmlNode* node, const Around& around) {
    const auto x1 = coordinate(node, "x1"), y1 = coordinate(node, "y1"), x2 = coordinate(node, "x2"),
               y2 = coordinate(node, "y2");
    for (const auto* value : {&x1, &y1, &x2, &y2})
      if (!*value) return tl::unexpected(value->error());
    add(around, {{*x1, *y1}, {*x2, *y2}}, false);
    return {};
  }
  Result<void> rect(const xmlNode* node, const Around& around) {
    const auto x = coordinate(node, "x"), y = coordinate(node, "y"), w = coordinate(node, "width"),
               h = coordinate(node, "height");
    for (const auto* value : {&x, &y, &w, &h})
      if (!*value) return tl::unexpected(value->error());
    if (attribute(node, "rx") || attribute(node, "ry")) return error("a rect with round corners", node);
    // Counter-clockwise once y is turned up.
    add(around, {{*x, *y + *h}, {*x + *w, *y + *h}, {*x + *w, *y}, {*x, *y}}, true);
    return {};
  }
  Result<void> text(const xmlNode* node, const Around& around) {
    const auto x = coordinate(node, "x"), y = coordinate(node, "y");
    if (!x) return tl::unexpected(x.error());
    if (!y) return tl::unexpected(y.error());
    std::string content = text_of(xmlNodeGetContent(const_cast<xmlNode*>(node)));
    const char* blanks = " \t\r\n";
    content.erase(0, content.find_first_not_of(blanks));
    content.erase(content.find_last_not_of(blanks) + 1);
    // Capitals are about 0.7 of the font's size high; the middle is half of that above the baseline.
    const auto font = coordinate(node, "font-size");
    if (!font) return tl::unexpected(font.error());
    drawing_.texts.push_back(
        {around.layer, around.panel, content, around.transform * Vector2d(*x, *y - 0.35 * *font)});
    return {};
  }

  std::string name_;
  ReadDrawing drawing_;
};

}  // namespace

std::string svg_reader_name() {
  return std::string("libxml2 ") + LIBXML_DOTTED_VERSION;
}

Result<ReadDrawing> read_svg(const std::filesystem::path& path) {
  const auto bytes = file_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string name = path.filename().string();
  // No network, no entities from elsewhere, nothing on the terminal.
  const std::unique_ptr<xmlDoc, FreeDocument> document(xmlReadMemory(
      bytes->data(), static_cast<int>(bytes->size()), name.c_str(), nullptr,
      XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_BIG_LINES | XML_PARSE_HUGE));
  const xmlNode* root = document ? xmlDocGetRootElement(document.get()) : nullptr;
  if (!root) {
    const xmlError* why = xmlGetLastError();
    std::string message = why && why->message ? why->message : "it is no XML";
    while (message.ends_with('\n')) message.pop_back();
    return fail(ErrorCode::Unreadable, message, name + ":" + std::to_string(why ? why->line : 0));
  }
  return Reader(name).read(root);
}

}  // namespace planewright
