/* What the smallest user of an installed planish looks like in C. */
#include <planish/planish.h>

#include <stdio.h>

int main(int argc, char **argv) {
  char request[4096];
  planish_result *result;
  int status;
  if (argc != 2) return 2;
  snprintf(request, sizeof request,
           "{\"maker\": \"unfold\", \"input\": \"%s\", \"artifacts\": [\"dxf\"]}", argv[1]);
  result = planish_run(request, NULL);
  status = planish_result_exit_status(result);
  if (planish_result_status(result) < PLANISH_REFUSED)
    printf("%s%s: %zu bytes\n", planish_result_summary(result),
           planish_result_artifact(result, 0)->name, planish_result_artifact(result, 0)->size);
  else
    fprintf(stderr, "%s\n", planish_result_error_message(result));
  planish_result_free(result);
  return status;
}
