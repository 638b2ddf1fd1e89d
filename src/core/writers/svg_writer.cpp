#include <map>
#include <numbers>
#include <pugixml.hpp>
#include <stdexcept>

#include "core/writers/clean_text.h"
#include "core/writers/drawing_writers.h"
#include "core/writers/file_layers.h"
#include "core/writers/number_text.h"

namespace planewright {
namespace {

// Height of the usual sans-serif faces' capital letters, parts of the font size.
constexpr double kCapitalHeight = 0.716;
// Lines are one pixel wide at any zoom, so that a sheet of 6 m and a part of 60 mm are both seen.
constexpr double kStroke = 1.0;
constexpr const char* kStyle = "path { vector-effect: non-scaling-stroke }";

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, size_t size) override { text.append(static_cast<const char*>(data), size); }
};

void set(pugi::xml_node& node, const char* attribute, const std::string& value) {
  node.append_attribute(attribute).set_value(value.c_str());
}

// The groups of one layer: one per panel, made when first asked for.
class LayerGroup {
 public:
  LayerGroup(pugi::xml_node& parent, const FileLayer& layer, const WorkshopModel& model)
      : group_(parent.append_child("g")), model_(model) {
    const std::string name(layer.name), colour(layer.svg_colour);
    set(group_, "id", name);
    set(group_, "inkscape:groupmode", "layer");
    set(group_, "inkscape:label", name);
    const bool text = name.starts_with("TEXT");
    set(group_, "fill", text ? colour : "none");
    set(group_, "stroke", text ? "none" : colour);
    if (!text) set(group_, "stroke-width", number_text(kStroke));
    if (!text) set(group_, "stroke-linejoin", "round");
  }

  // Of a panel; -1: what belongs to none.
  pugi::xml_node& panel(int panel) {
    if (panel < 0) return group_;
    const auto [place, made] = panels_.try_emplace(panel);
    if (made) {
      place->second = group_.append_child("g");
      const std::string name = clean_text(model_.names.at(panel));
      set(place->second, "data-panel", name);
      set(place->second, "inkscape:label", name);
    }
    return place->second;
  }

 private:
  pugi::xml_node group_;
  const WorkshopModel& model_;
  std::map<int, pugi::xml_node> panels_;
};

void add_line(pugi::xml_node& group, const DrawingLine& line, double page_height) {
  std::string path;
  for (Eigen::Index i = 0; i < line.points.rows(); ++i) {
    path += i == 0 ? "M " : " L ";
    append_number(path, line.points(i, 0));
    path += ' ';
    append_number(path, page_height - line.points(i, 1));
  }
  if (line.closed) path += " Z";
  pugi::xml_node node = group.append_child("path");
  set(node, "d", path);
}

void add_text(pugi::xml_node& group, const DrawingText& text, const FileLayer& layer, bool layer_is_text,
              double page_height) {
  const std::string x = number_text(text.at.x()), y = number_text(page_height - text.at.y());
  pugi::xml_node node = group.append_child("text");
  set(node, "class", text.is_name ? "name" : "note");
  set(node, "x", x);
  // The baseline: half the capital letters' height below the middle.
  set(node, "y", number_text(page_height - text.at.y() + text.height / 2.0));
  set(node, "font-size", number_text(text.height / kCapitalHeight));
  if (text.rotation != 0.0)
    set(node, "transform",
        "rotate(" + number_text(-text.rotation * 180.0 / std::numbers::pi) + " " + x + " " + y + ")");
  // On a layer of lines the group says "not filled".
  if (!layer_is_text) {
    set(node, "fill", std::string(layer.svg_colour));
    set(node, "stroke", "none");
  }
  node.text().set(clean_text(text.text).c_str());
}

}  // namespace

std::string format_svg(const WorkshopModel& model, const Drawing& drawing) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node svg = document.append_child("svg");
  set(svg, "xmlns", "http://www.w3.org/2000/svg");
  set(svg, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
  set(svg, "version", "1.1");
  const std::string width = number_text(drawing.width), height = number_text(drawing.height);
  set(svg, "width", width + "mm");
  set(svg, "height", height + "mm");
  set(svg, "viewBox", "0 0 " + width + " " + height);
  set(svg, "font-family", "Inter, Arial, Helvetica, sans-serif");
  set(svg, "text-anchor", "middle");
  pugi::xml_node title = svg.append_child("title");
  title.text().set(clean_text(drawing.title).c_str());

  svg.append_child("style").text().set(kStyle);

  std::vector<LayerGroup> layers;
  layers.reserve(kFileLayers.size());
  for (const FileLayer& layer : kFileLayers) layers.emplace_back(svg, layer, model);
  for (const DrawingLine& line : drawing.lines)
    add_line(layers[file_layer(line)].panel(line.panel), line, drawing.height);
  for (const DrawingText& text : drawing.texts) {
    const int layer = file_layer(text);
    add_text(layers[layer].panel(text.panel), text, kFileLayers[layer], text.layer == DrawingLayer::Text,
             drawing.height);
  }
  StringWriter writer;
  document.save(writer, " ", pugi::format_default, pugi::encoding_utf8);
  return std::move(writer.text);
}

}  // namespace planewright
