#pragma once

#include <slalom/gui/form.h>
#include <slalom/gui/studio.h>

namespace slalom {

// What is asked before something is done with the lists that are open. Each form does it when it is
// accepted; what is in the way is shown in the form. All but the first three need an open list.

FormDescription open_list_form(Studio& studio);
FormDescription new_list_form(Studio& studio);
FormDescription open_results_form(Studio& studio);
FormDescription save_as_form(Studio& studio);
FormDescription copy_form(Studio& studio);  ///< the selected scenarios to another open list
FormDescription move_form(Studio& studio);
FormDescription rename_form(Studio& studio);  ///< the current scenario
FormDescription tag_form(Studio& studio);     ///< the selected scenarios
FormDescription create_index_form(Studio& studio);
FormDescription drop_index_form(Studio& studio);
FormDescription deduplicate_form(Studio& studio);

}  // namespace slalom
