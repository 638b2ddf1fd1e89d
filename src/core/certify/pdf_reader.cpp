#include "core/certify/pdf_reader.h"

#include <Eigen/Geometry>
#include <cmath>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>

#include "core/certify/file_bytes.h"
#include "core/certify/pdf_font.h"

namespace planewright {
namespace {

using Eigen::Affine2d;
using Eigen::Vector2d;

constexpr double kPoint = 25.4 / 72.0;  // mm

Affine2d matrix(double a, double b, double c, double d, double e, double f) {
  Affine2d m = Affine2d::Identity();
  m.matrix() << a, c, e, b, d, f, 0.0, 0.0, 1.0;
  return m;
}

// A content stream that is not what we can follow; becomes an Error in read_pdf.
struct Unfollowed {
  std::string what;
};

struct TextState {
  PdfFont font;
  double size = 1.0, spacing = 0.0, word_spacing = 0.0, stretch = 1.0, leading = 0.0, rise = 0.0;
};
struct GraphicsState {
  Affine2d to_page;  // mm
  TextState text;
};

class Interpreter : public QPDFObjectHandle::ParserCallbacks {
 public:
  Interpreter(ReadPage& page, QPDFObjectHandle resources, GraphicsState state, int depth)
      : page_(page), resources_(std::move(resources)), state_(std::move(state)), depth_(depth) {}

  void handleObject(QPDFObjectHandle object, size_t, size_t) override {
    if (object.isOperator()) {
      perform(object.getOperatorValue());
      operands_.clear();
    } else if (!object.isInlineImage()) {
      operands_.push_back(object);
    }
  }
  void handleEOF() override {
    if (!saved_.empty()) throw Unfollowed{"a content stream with 'q' but no 'Q'"};
  }

 private:
  double number(size_t i) const {
    if (i >= operands_.size() || !QPDFObjectHandle(operands_[i]).isNumber())
      throw Unfollowed{"an operator without its numbers"};
    return QPDFObjectHandle(operands_[i]).getNumericValue();
  }
  Vector2d point(size_t i) const { return {number(i), number(i + 1)}; }
  Affine2d operand_matrix() const {
    return matrix(number(0), number(1), number(2), number(3), number(4), number(5));
  }

  void perform(const std::string& op) {
    if (op == "q") {
      saved_.push_back(state_);
    } else if (op == "Q") {
      if (saved_.empty()) throw Unfollowed{"a content stream with 'Q' but no 'q'"};
      state_ = saved_.back();
      saved_.pop_back();
    } else if (op == "cm") {
      state_.to_page = state_.to_page * operand_matrix();
    } else if (op == "Do") {
      form();
    } else if (!path(op)) {
      text(op);
    }
  }

  // --- Paths ----------------------------------------------------------------------------------------------

  bool path(const std::string& op) {
    if (op == "m") {
      begin(point(0));
    } else if (op == "l") {
      extend(point(0));
    } else if (op == "c") {
      extend(point(4), true);
    } else if (op == "v" || op == "y") {
      extend(point(2), true);
    } else if (op == "re") {
      const Vector2d p = point(0), size = point(2);
      begin(p);
      extend(p + Vector2d(size.x(), 0.0));
      extend(p + size);
      extend(p + Vector2d(0.0, size.y()));
      close();
    } else if (op == "h") {
      close();
    } else if (op == "S" || op == "f" || op == "F" || op == "f*" || op == "B" || op == "B*") {
      paint();
    } else if (op == "s" || op == "b" || op == "b*") {
      close();
      paint();
    } else if (op == "n") {
      pieces_.clear();  // a clip
    } else {
      return false;
    }
    return true;
  }

  struct Piece {
    std::vector<Vector2d> points;
    bool closed = false, curved = false;
  };
  void begin(const Vector2d& p) { pieces_.push_back({{state_.to_page * p}, false, false}); }
  void extend(const Vector2d& p, bool curve = false) {
    if (pieces_.empty()) throw Unfollowed{"a path that begins nowhere"};
    if (pieces_.back().closed) pieces_.push_back({{pieces_.back().points.front()}, false, false});
    pieces_.back().points.push_back(state_.to_page * p);
    pieces_.back().curved |= curve;
  }
  void close() {
    if (!pieces_.empty()) pieces_.back().closed = true;
  }
  void paint() {
    for (const Piece& piece : pieces_) {
      auto points = piece.points;
      if (points.size() > 1 && points.front() == points.back()) points.pop_back();
      if (piece.curved || points.size() < 2) continue;
      ReadLine line{{}, {}, Contour(static_cast<Eigen::Index>(points.size()), 2), piece.closed};
      for (size_t i = 0; i < points.size(); ++i) line.points.row(static_cast<Eigen::Index>(i)) = points[i];
      page_.lines.push_back(std::move(line));
    }
    pieces_.clear();
  }

  // --- Text -----------------------------------------------------------------------------------------------

  void text(const std::string& op) {
    TextState& t = state_.text;
    if (op == "BT") {
      line_ = at_ = Affine2d::Identity();
    } else if (op == "ET") {
      end_text();
    } else if (op == "Tf") {
      set_font();
    } else if (op == "Tc") {
      t.spacing = number(0);
    } else if (op == "Tw") {
      t.word_spacing = number(0);
    } else if (op == "Tz") {
      t.stretch = number(0) / 100.0;
    } else if (op == "TL") {
      t.leading = number(0);
    } else if (op == "Ts") {
      t.rise = number(0);
    } else if (op == "Td") {
      move(point(0));
    } else if (op == "TD") {
      t.leading = -number(1);
      move(point(0));
    } else if (op == "T*") {
      move({0.0, -t.leading});
    } else if (op == "Tm") {
      end_text();
      line_ = at_ = operand_matrix();
    } else if (op == "Tj") {
      if (!operands_.empty()) show(operands_[0]);
    } else if (op == "'") {
      move({0.0, -t.leading});
      if (!operands_.empty()) show(operands_[0]);
    } else if (op == "\"") {
      move({0.0, -t.leading});
      if (operands_.size() == 3) show(operands_[2]);
    } else if (op == "TJ") {
      if (operands_.empty() || !operands_[0].isArray()) throw Unfollowed{"'TJ' without a list"};
      for (int i = 0; i < operands_[0].getArrayNItems(); ++i) {
        QPDFObjectHandle item = operands_[0].getArrayItem(i);
        if (item.isString()) {
          show(item);
        } else if (item.isNumber()) {
          // A jump of more than a third of an em is another text on the same line.
          if (std::abs(item.getNumericValue()) > 333.0) end_text();
          at_.translate(Vector2d(-item.getNumericValue() / 1000.0 * t.size * t.stretch, 0.0));
        }
      }
    }
    // Everything else (colours, line styles, marks) moves nothing.
  }

  void move(const Vector2d& by) {
    end_text();
    line_.translate(by);
    at_ = line_;
  }
  void set_font() {
    if (operands_.size() != 2 || !operands_[0].isName()) throw Unfollowed{"'Tf' without a font"};
    state_.text.size = number(1);
    QPDFObjectHandle fonts =
        resources_.isDictionary() ? resources_.getKey("/Font") : QPDFObjectHandle::newNull();
    const std::string name = operands_[0].getName();
    if (!fonts.isDictionary() || !fonts.hasKey(name)) throw Unfollowed{"a font that is not there"};
    auto known = fonts_.find(name);
    if (known == fonts_.end()) known = fonts_.emplace(name, PdfFont(fonts.getKey(name))).first;
    state_.text.font = known->second;
  }
  void show(QPDFObjectHandle string) {
    if (!string.isString()) throw Unfollowed{"a text that is no string"};
    const TextState& t = state_.text;
    for (const PdfFont::Glyph& glyph : t.font.glyphs(string.getStringValue())) {
      if (shown_.text.empty()) begins_ = state_.to_page * (at_ * Vector2d(0.0, t.rise));
      shown_.text += glyph.text;
      double step = glyph.width * t.size + t.spacing;
      if (glyph.text == " ") step += t.word_spacing;
      at_.translate(Vector2d(step * t.stretch, 0.0));
      // Capitals are about 0.7 of the font's size high; the middle is half of that above the baseline.
      const Vector2d ends = state_.to_page * (at_ * Vector2d(0.0, t.rise));
      const Vector2d up = state_.to_page.linear() * (at_.linear() * Vector2d(0.0, 0.35 * t.size));
      shown_.at = 0.5 * (begins_ + ends) + up;
      shown_.width = (ends - begins_).norm();
      shown_.height = 2.0 * up.norm();
    }
  }
  void end_text() {
    if (!shown_.text.empty()) page_.texts.push_back(std::move(shown_));
    shown_ = {};
  }

  // --- Forms ----------------------------------------------------------------------------------------------

  void form() {
    if (operands_.empty() || !operands_[0].isName() || !resources_.isDictionary()) return;
    QPDFObjectHandle objects = resources_.getKey("/XObject");
    if (!objects.isDictionary() || !objects.hasKey(operands_[0].getName()))
      throw Unfollowed{"a form that is not there"};
    QPDFObjectHandle object = objects.getKey(operands_[0].getName());
    if (!object.isStream() || !object.getDict().getKey("/Subtype").isNameAndEquals("/Form")) return;
    if (depth_ > 8) throw Unfollowed{"forms inside forms without end"};
    GraphicsState inside = state_;
    if (QPDFObjectHandle m = object.getDict().getKey("/Matrix"); m.isMatrix()) {
      const auto v = m.getArrayAsMatrix();
      inside.to_page = inside.to_page * matrix(v.a, v.b, v.c, v.d, v.e, v.f);
    }
    QPDFObjectHandle own = object.getDict().getKey("/Resources");
    Interpreter interpreter(page_, own.isDictionary() ? own : resources_, inside, depth_ + 1);
    QPDFObjectHandle::parseContentStream(object, &interpreter);
  }

  ReadPage& page_;
  QPDFObjectHandle resources_;
  GraphicsState state_;
  int depth_;
  std::vector<GraphicsState> saved_;
  std::vector<QPDFObjectHandle> operands_;
  std::vector<Piece> pieces_;
  Affine2d line_ = Affine2d::Identity(), at_ = Affine2d::Identity();
  ReadText shown_;
  Vector2d begins_ = Vector2d::Zero();  // of the text that is being shown, on the page
  std::map<std::string, PdfFont> fonts_;
};

ReadPage read_page(QPDFPageObjectHelper& helper) {
  QPDFObjectHandle box = helper.getMediaBox();
  if (!box.isRectangle()) throw Unfollowed{"a page without media box"};
  const auto r = box.getArrayAsRectangle();
  ReadPage page;
  page.width = (r.urx - r.llx) * kPoint;
  page.height = (r.ury - r.lly) * kPoint;
  GraphicsState state{matrix(kPoint, 0.0, 0.0, kPoint, -r.llx * kPoint, -r.lly * kPoint), {}};
  Interpreter interpreter(page, helper.getAttribute("/Resources", false), state, 0);
  helper.parseContents(&interpreter);
  return page;
}

}  // namespace

std::string pdf_reader_name() {
  return "qpdf " + QPDF::QPDFVersion();
}

Result<std::vector<ReadPage>> read_pdf(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (const auto bytes = file_bytes(path); !bytes) return tl::unexpected(bytes.error());
  // qpdf tells by exceptions what it cannot read.
  try {
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);
    pdf.processFile(path.c_str());
    std::vector<ReadPage> pages;
    for (QPDFPageObjectHelper& helper : QPDFPageDocumentHelper(pdf).getAllPages())
      pages.push_back(read_page(helper));
    if (pdf.anyWarnings())
      return fail(ErrorCode::Unreadable, pdf.getWarnings().front().getMessageDetail(), name);
    return pages;
  } catch (const Unfollowed& unfollowed) {
    return fail(ErrorCode::Unreadable, unfollowed.what, name);
  } catch (const std::exception& exception) {
    return fail(ErrorCode::Unreadable, exception.what(), name);
  }
}

}  // namespace planewright
