#pragma once

#include <slalom/studio/form.h>
#include <slalom/studio/studio.h>

namespace slalom {

// Forms of actions on lists. Each form runs its action when it is accepted, and shows errors. All
// but the first three require an open list.

FormDescription open_list_form(Studio& studio);
FormDescription new_list_form(Studio& studio);
FormDescription open_results_form(Studio& studio);
FormDescription save_as_form(Studio& studio);
FormDescription copy_form(Studio& studio);  ///< of the selected scenarios to another open list
FormDescription move_form(Studio& studio);
FormDescription rename_form(Studio& studio);  ///< of the current scenario
FormDescription tag_form(Studio& studio);     ///< of the selected scenarios
FormDescription create_index_form(Studio& studio);
FormDescription drop_index_form(Studio& studio);
FormDescription deduplicate_form(Studio& studio);

}  // namespace slalom
