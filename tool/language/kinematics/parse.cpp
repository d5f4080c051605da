#include <algorithm>
#include <utility>

#include "language/common/content.h"
#include "language/kinematics/block_parser.h"
#include "language/kinematics/keywords.h"
#include "language/kinematics/parse_couplings.h"
#include "language/kinematics/parse_joint.h"
#include "language/kinematics/parse_link.h"
#include "language/kinematics/parse_loops.h"
#include "language/kinematics/parse_part.h"

namespace robcogen::language::kinematics {
namespace {

constexpr std::string_view kCouplings = "couplings";

// Parses a robot document: elements in the block of the robot, and items in the block of an element, both in any order.
class Parser : private BlockParser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : BlockParser(Cursor(tokenize_document(source, diagnostics), keywords(), diagnostics)),
        source_(std::move(source)),
        errors_before_(diagnostics.error_count()),
        diagnostics_(diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      imports_and_parts();
      if (!is_library()) {
        header();
        elements();
        end();
        check_bases();
      }
    } catch (const SyntaxError&) {
    } catch (const OtherLanguage&) {
      // reported; the rest of the file is not read
    }
    std::stable_partition(
        document_.links.begin(), document_.links.end(), [](const Link& link) { return link.is_base; });
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  std::size_t errors_before_;
  const Diagnostics& diagnostics_;
  Document document_;
  Body* body_ = &document_;     // the robot, or the part being parsed
  const Part* part_ = nullptr;  // the part being parsed, or nullptr
  std::vector<Name> bases_;     // including bases with errors
  bool may_have_skipped_base_ = false;

  // -------------------------------------------------------------------------------------------------------------------
  // The robot: its header, its elements, its end.

  void imports_and_parts() {
    while (cursor_.at("import") || at_part(cursor_)) {
      cursor_.begin_statement();
      try {
        if (cursor_.at("import"))
          document_.imports.push_back(import_of(*this));
        else
          part();
      } catch (const SyntaxError&) {
        cursor_.skip_until([&] { return at_robot() || at_part(cursor_) || at_element(); });
        if (!at_robot() && !at_part(cursor_)) throw;
      }
    }
  }

  bool at_robot() const { return cursor_.at("Robot") && cursor_.at("{", 2); }

  // Whether the document has only imports and parts, for use by other documents.
  bool is_library() {
    if (!cursor_.at_end() || (document_.imports.empty() && document_.parts.empty())) return false;
    document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
    return true;
  }

  void part() {
    Part part = part_head(*this);
    const std::string owner = fmt::format("part '{}'", part.name.text);
    const Token open = cursor_.expect("{", "after " + owner);
    body_ = &part;
    part_ = &part;
    elements(&part.roots);
    body_ = &document_;
    part_ = nullptr;
    if (at_robot()) {
      cursor_.error("missing-brace", fmt::format("expected '}}' at the end of {}, found 'Robot'", owner))
          .notes.push_back({cursor_.place(open.span), "opened here"});
      cursor_.assume_closing_brace();
    } else {
      cursor_.expect("}", "at the end of " + owner);
    }
    part.trailing_comments = cursor_.comments_before(cursor_.previous().span.end);
    if (part.roots.empty())
      cursor_.error_at(part.name.span, "no-root", fmt::format("{} has no root", owner)).hint =
          "write 'root LINK via JOINT' for its first link and the joint that carries it";
    document_.parts.push_back(std::move(part));
  }

  void header() {
    document_.comments = cursor_.comments_before(cursor_.peek().span.begin);
    try {
      cursor_.expect("Robot", "at the beginning of a robot document");
      document_.robot = name("the name of the robot");
      cursor_.expect("{", "after the name of the robot");
    } catch (const SyntaxError&) {
      may_have_skipped_base_ = true;
      cursor_.skip_until([&] { return at_element(); });
      if (cursor_.at_end()) throw;
    }
  }

  void elements(std::vector<Child>* roots = nullptr) {
    while (!cursor_.at("}") && !cursor_.at_end() && !(roots && at_robot())) {
      cursor_.begin_statement();
      try {
        if (roots && at_root(cursor_)) {
          roots->push_back(root(*this));
        } else if (cursor_.at_any({"RobotBase", "link"})) {
          if (cursor_.at("RobotBase") && part_ == nullptr)
            bases_.push_back({std::string(cursor_.peek(1).text), cursor_.peek(1).span});
          link(*this, *body_, part_);
        } else if (cursor_.at_any({"r_joint", "p_joint"}) || at_new_element()) {
          joint(*this, *body_);
        } else if (at_couplings()) {
          couplings(*this, *body_);
        } else if (at_loops(cursor_)) {
          loops(*this, *body_);
        } else if (at_actuators(cursor_)) {
          actuators(*this, *body_);
        } else if (at_tendons(cursor_)) {
          tendons(*this, *body_);
        } else if (at_independent(cursor_)) {
          independent(*this, *body_);
        } else {
          unknown_element();
        }
      } catch (const SyntaxError&) {
        cursor_.skip_until([&] { return at_element(); });
        if (cursor_.at_end()) throw;
      }
    }
  }

  // `couplings` is not a keyword: elements may have this name.
  bool at_couplings() const { return cursor_.at(kCouplings) && cursor_.at("{", 1); }

  void unknown_element() {
    may_have_skipped_base_ = true;
    const Token& token = cursor_.peek();
    if (!cursor_.is_faulty_here()) {
      Diagnostic& d = cursor_.error(
          "unknown-element", fmt::format("expected {} or '}}', found {}", quoted(kElements), describe(token)));
      std::vector<std::string> words(kElements.begin(), kElements.end());
      words.insert(words.end(), kNewElements.begin(), kNewElements.end());
      words.insert(words.end(), {std::string(kCouplings), "loops", "independent", "actuators", "tendons"});
      const std::string_view joint = keyword_of_joint(token.text);
      if (!joint.empty())
        d.hint = fmt::format("did you mean '{}'?", joint);
      else if (token.kind == Token::Kind::identifier)
        d.hint = suggest_keyword(token.text, words);
      if (at_instance(cursor_)) d.hint = "list a part under 'children' of the link that carries it";
    }
    cursor_.skip_until([&] { return cursor_.at("{") || cursor_.at("}") || at_element(); });
    if (!cursor_.accept("{")) return;
    const std::size_t inside = cursor_.open_blocks();
    cursor_.skip_until([&] { return at_element() || (cursor_.at("}") && cursor_.open_blocks() == inside); });
    cursor_.accept("}");
  }

  // If elements follow the brace that ends the robot, there is one brace too many before it; these elements are read
  // too. This is not reported after other errors, which may be about a brace.
  void end() {
    if (cursor_.at_end() && cursor_.open_blocks() == 0) return;  // there was an error in the header
    const Token brace = cursor_.expect("}", "at the end of the robot");
    document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
    if (cursor_.at_end()) return;
    const bool is_part = at_part(cursor_) || cursor_.at("import");
    const bool may_follow = at_element() && diagnostics_.error_count() > errors_before_;
    if (!may_follow && !cursor_.is_faulty_here()) report_text_after(brace, is_part);
    while (at_element()) {
      elements();
      cursor_.take();
    }
  }

  void report_text_after(const Token& brace, bool is_part) {
    Diagnostic& d =
        cursor_.error("text-after-end", fmt::format("{} follows the end of the robot", describe(cursor_.peek())));
    d.notes.push_back({cursor_.place(brace.span), "the robot ends here"});
    if (is_part) d.hint = "write imports and parts before the robot";
  }

  void check_bases() {
    if (bases_.empty() && !may_have_skipped_base_)
      cursor_.error_at(
          document_.robot.span, "no-base", fmt::format("robot '{}' has no RobotBase", document_.robot.text));
    for (std::size_t i = 1; i < bases_.size(); ++i)
      cursor_.error_at(bases_[i].span, "two-bases", fmt::format("'{}' is a second base", bases_[i].text))
          .notes.push_back({cursor_.place(bases_[0].span), "the first base is here"});
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::kinematics
