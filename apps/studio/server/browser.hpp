#pragma once

#include <filesystem>
#include <string>

namespace planish::studio {

/// Opens an address in the user's browser, if there is a desktop with xdg-open. Everyone on the
/// machine can read command lines, so the browser gets a file in `folder` that redirects to the
/// address.
void open_in_browser(const std::string& address, const std::filesystem::path& folder);

/// Shows a sentence in the browser, as above, and waits until it has had time to read the file.
void say_in_browser(const std::string& sentence, const std::filesystem::path& folder);

}  // namespace planish::studio
