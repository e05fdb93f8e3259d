#pragma once

#include <filesystem>
#include <string>

namespace planish::studio {

/// Opens an address in the user's browser, where there is a desktop with xdg-open. Command lines
/// can be read by everyone on the machine, so the browser is given a file in `folder` that leads to
/// the address.
void open_in_browser(const std::string& address, const std::filesystem::path& folder);

}  // namespace planish::studio
