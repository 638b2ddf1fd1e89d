// ElementRef: which element of a complex a row, a violation or a finding is about, so that a report can name
// it and the window can show it. Indices: of the TangentComplex, 0-based.
#pragma once

#include <compare>
#include <string>

namespace planewright {

enum class ElementKind { Point, Panel, PanelEdge };

struct ElementRef {
  ElementKind kind = ElementKind::Point;
  int index = 0;
  auto operator<=>(const ElementRef&) const = default;
};

inline const char* name(ElementKind kind) {
  switch (kind) {
    case ElementKind::Point:
      return "point";
    case ElementKind::Panel:
      return "panel";
    case ElementKind::PanelEdge:
      return "panel edge";
  }
  return "";
}

// "panel 17"
inline std::string text(const ElementRef& element) {
  return std::string(name(element.kind)) + " " + std::to_string(element.index);
}

}  // namespace planewright
