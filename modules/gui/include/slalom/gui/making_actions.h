#pragma once

#include <slalom/gui/studio_services.h>
#include <slalom/gui/studio_window.h>

#include <memory>

namespace slalom {

// Actions that make scenarios, or write them for other programs, by workers.

using StudioServicesPtr = std::shared_ptr<const StudioServices>;

/// Import and export; files that are dropped on the window are opened or imported.
void add_exchange_actions(StudioWindow& window, StudioServicesPtr services);
void add_generate_actions(StudioWindow& window, StudioServicesPtr services);

/// Asks how these files are to be imported.
void ask_to_import(StudioWindow& window, const StudioServicesPtr& services,
                   const std::vector<std::string>& files);

}  // namespace slalom
