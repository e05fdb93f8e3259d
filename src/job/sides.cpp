#include "sides.hpp"

#include "refusals.hpp"

#include <planish/schema/schema.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <utility>
#include <vector>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

using FaceTest = std::function<bool(const Face&)>;

bool is_flange_face(const Face& face) { return std::holds_alternative<FlangeId>(face.part_of); }

// The sheet's face that came from face `number` of the solid.
std::optional<FaceId> face_numbered(const Sheet& sheet, int number, const FaceTest& wanted) {
  for (const FaceId id : sheet.faces.ids())
    if (sheet[id].source_face == number && wanted(sheet[id])) return id;
  return std::nullopt;
}

std::vector<int> numbers(const Sheet& sheet, const FaceTest& wanted) {
  std::vector<int> found;
  for (const Face& face : sheet.faces) {
    if (face.source_face && wanted(face)) found.push_back(*face.source_face);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// "faces 1, 3, 4".
std::string faces_text(const Sheet& sheet, const FaceTest& wanted) {
  return fmt::format("faces {}", fmt::join(numbers(sheet, wanted), ", "));
}

Result<int> face_number(const std::string& text, const std::string& option,
                        const std::string& words) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc() && stop == end) return number;
  return fail(refuse::bad_face_number, {{"option", option}, {"words", words}, {"text", text}},
              option);
}

Result<std::optional<FaceId>> root_face(const Sheet& sheet, const std::string& root) {
  if (root == "largest") return std::optional<FaceId>();
  const Result<int> number = face_number(root, "root", "largest");
  if (!number) return pass_on(number);
  const auto found = face_numbered(sheet, *number, is_flange_face);
  if (found) return found;
  return fail(refuse::not_a_root,
              {{"face", place::face(*number)}, {"known", faces_text(sheet, is_flange_face)}},
              "root");
}

Result<UpSide> up_side(const Sheet& sheet, const std::string& up) {
  if (up == "auto") return UpSide::automatic;
  if (up == "reference") return UpSide::reference;
  if (up == "other") return UpSide::other;
  const Result<int> number = face_number(up, "up", "auto, reference, other");
  if (!number) return pass_on(number);
  const FaceTest any = [](const Face&) { return true; };
  if (face_numbered(sheet, *number, any)) return UpSide::reference;
  return fail(refuse::not_on_skin,
              {{"face", place::face(*number)}, {"known", faces_text(sheet, any)}}, "up");
}

Result<std::vector<std::pair<BendId, double>>> single_bends(const Sheet& sheet,
                                                            const Request& request) {
  const int count = static_cast<int>(sheet.bends.size());
  std::vector<std::pair<BendId, double>> rows;
  for (const auto& [id, k] : request.bend_k) {
    int number = 0;
    while (number < count && id != fmt::format("B{}", number + 1))
      ++number;
    if (number == count)
      return fail(count == 0 ? refuse::no_bends : refuse::no_such_bend,
                  {{"bend", place::bend(id)}, {"known", fmt::format("B1 to B{}", count)}},
                  "bend_k/" + escaped_token(id));
    rows.emplace_back(BendId{number}, k);
  }
  return rows;
}

}  // namespace

Result<FlattenOptions> flatten_options(const Sheet& sheet, const Request& request) {
  FlattenOptions options;
  options.extruded = request.extruded;
  options.allowance = request.allowance ? *request.allowance
                      : request.shop    ? shop_k(*request.shop, sheet.thickness)
                                        : ConstantK{};
  const auto bend_k = single_bends(sheet, request);
  if (!bend_k) return pass_on(bend_k);
  options.bend_k = *bend_k;
  const auto root = root_face(sheet, request.root);
  if (!root) return pass_on(root);
  options.root = *root;
  const auto up = up_side(sheet, request.up);
  if (!up) return pass_on(up);
  options.up = *up;
  return options;
}

}  // namespace planish::job
