#include "step_text.hpp"

#include <TCollection_ExtendedString.hxx>

namespace planish::brep {

std::string step_text(const Handle(TCollection_HAsciiString) & text) {
  if (text.IsNull() || text->UsefullLength() == 0) return {};
  const TCollection_ExtendedString wide(text->ToCString(), true);
  std::string name(static_cast<size_t>(wide.LengthOfCString()), '\0');
  Standard_PCharacter raw = name.data();
  wide.ToUTF8CString(raw);
  return name;
}

}  // namespace planish::brep
