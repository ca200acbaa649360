/* The trap: without the header's SLALOM_METHOD_EXPORT, hidden visibility hides the function. */
const void* slalom_method_get_api(void);

const void* slalom_method_get_api(void) {
  return 0;
}
