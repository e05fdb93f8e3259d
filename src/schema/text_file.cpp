#include "refusals.hpp"

#include <planish/schema/text_file.hpp>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>
#include <vector>

namespace planish::schema {
namespace {

// In blocks: reading character by character would take longer than parsing.
std::string all_of(std::istream& stream) {
  std::string text;
  std::vector<char> piece(1 << 16);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) ||
         stream.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace

Error cannot_read(const std::string& what, const std::filesystem::path& file,
                  const std::string& reason) {
  return error_of(refuse::cannot_read,
                  {{"what", what}, {"file", file.string()}, {"reason", reason}}, file.string());
}

Result<std::string> read_text(const std::filesystem::path& name, const std::string& what) {
  if (name == "-") return all_of(std::cin);
  std::error_code ignored;
  const auto refuse = [&](const std::string& why) { return fail(cannot_read(what, name, why)); };
  if (std::filesystem::is_directory(name, ignored)) return refuse("it is a folder");
  std::ifstream file(name, std::ios::binary);
  if (!file) return refuse(std::generic_category().message(errno));
  std::string text = all_of(file);
  if (file.bad()) return refuse("reading it failed");
  return text;
}

}  // namespace planish::schema
