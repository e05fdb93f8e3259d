#include "dxf_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace planish::io_detail {
namespace {

std::string decimal(double value) {
  constexpr double kZero = 1e-15;
  if (std::abs(value) < kZero) return "0.0";
  std::array<char, 400> buffer{};  // the largest double has 309 digits
  const auto end = std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed).ptr;
  std::string text(buffer.begin(), end);
  if (text.find('.') == std::string::npos) text += ".0";
  return text;
}

}  // namespace

DL_Codes::version dxflib_version(DxfVersion version) {
  return version == DxfVersion::r12 ? DL_Codes::AC1009 : DL_Codes::AC1015;
}

// The base opens a file of that name; an empty name opens none.
DxfWriter::DxfWriter(DxfVersion dxf_version) : DL_WriterA("", dxflib_version(dxf_version)) {}

void DxfWriter::dxfReal(int code, double value) const { dxfString(code, decimal(value)); }

void DxfWriter::dxfInt(int code, int value) const { dxfString(code, fmt::format("{}", value)); }

void DxfWriter::dxfHex(int code, int value) const { dxfString(code, fmt::format("{:X}", value)); }

void DxfWriter::dxfString(int code, const char* value) const {
  // dxflib begins with a comment that names its version: legal, but simple readers expect the first
  // section on the first line.
  if (code == 999) return;
  text_ += fmt::format("{:3}\n{}\n", code, value);
}

void DxfWriter::dxfString(int code, const std::string& value) const {
  dxfString(code, value.c_str());
}

}  // namespace planish::io_detail
