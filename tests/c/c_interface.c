/* The C interface, used as a program in C does: c_interface_test.py runs it. */
#include <planish/planish.h>

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                        \
  do {                                                                          \
    if (!(condition)) {                                                         \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                               \
    }                                                                           \
  } while (0)

/* ---- abi: what a program that is compiled today relies on ---- */

#define MEMBER(type, member)                                                            \
  printf("%s.%s %zu %zu\n", #type, #member, offsetof(type, member), \
         sizeof(((type *)NULL)->member))

static int print_abi(void) {
  /* Whoever changes a signature breaks these. */
  const char *(*version)(void) = planish_version;
  int (*abi)(void) = planish_abi;
  planish_result *(*run)(const char *, const planish_options *) = planish_run;
  void (*result_free)(planish_result *) = planish_result_free;
  int (*status)(const planish_result *) = planish_result_status;
  int (*exit_status)(const planish_result *) = planish_result_exit_status;
  const char *(*texts[])(const planish_result *) = {
      planish_result_report, planish_result_summary, planish_result_error_code,
      planish_result_error_message, planish_result_error_where};
  size_t (*count)(const planish_result *) = planish_result_artifact_count;
  const planish_artifact *(*artifact)(const planish_result *, size_t) = planish_result_artifact;
  size_t (*schema_count)(void) = planish_schema_count;
  const char *(*schema_name)(size_t) = planish_schema_name;
  const char *(*schema)(const char *) = planish_schema;
  const char *(*catalogue)(void) = planish_catalogue;
  planish_progress progress = NULL;
  if (!version || !abi || !run || !result_free || !status || !exit_status || !texts[0] || !count ||
      !artifact || !schema_count || !schema_name || !schema || !catalogue || progress)
    return 1;
  printf("PLANISH_ABI %d\n", PLANISH_ABI);
  printf("PLANISH_OK %d\nPLANISH_WARNING %d\nPLANISH_REFUSED %d\nPLANISH_FAILED %d\n", PLANISH_OK,
         PLANISH_WARNING, PLANISH_REFUSED, PLANISH_FAILED);
  printf("PLANISH_APART %d\nPLANISH_HERE %d\n", PLANISH_APART, PLANISH_HERE);
  printf("planish_options %zu\n", sizeof(planish_options));
  MEMBER(planish_options, size);
  MEMBER(planish_options, where);
  MEMBER(planish_options, reserved);
  MEMBER(planish_options, time_limit);
  MEMBER(planish_options, memory_limit);
  MEMBER(planish_options, progress);
  MEMBER(planish_options, user);
  printf("planish_artifact %zu\n", sizeof(planish_artifact));
  MEMBER(planish_artifact, artifact);
  MEMBER(planish_artifact, name);
  MEMBER(planish_artifact, media_type);
  MEMBER(planish_artifact, bytes);
  MEMBER(planish_artifact, size);
  return planish_abi() == PLANISH_ABI ? 0 : 1;
}

/* ---- run: one request, its files into a folder ---- */

static char *read_file(const char *path) {
  FILE *file = fopen(path, "rb");
  char *text;
  long size;
  if (!file) return NULL;
  fseek(file, 0, SEEK_END);
  size = ftell(file);
  rewind(file);
  text = malloc((size_t)size + 1);
  if (text) text[fread(text, 1, (size_t)size, file)] = '\0';
  fclose(file);
  return text;
}

static int write_file(const char *folder, const char *name, const void *bytes, size_t size) {
  char path[4096];
  FILE *file;
  int fine;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  file = fopen(path, "wb");
  if (!file) return 0;
  fine = fwrite(bytes, 1, size, file) == size;
  return fclose(file) == 0 && fine;
}

static int run_request(const char *request_file, const char *folder, const char *where) {
  planish_options options = PLANISH_OPTIONS_INIT;
  char *request = read_file(request_file);
  planish_result *result;
  size_t i;
  if (!request) return 1;
  if (strcmp(where, "here") == 0) options.where = PLANISH_HERE;
  result = planish_run(request, &options);
  free(request);
  printf("%d\n%d\n%s\n%s\n%s\n", planish_result_status(result), planish_result_exit_status(result),
         planish_result_error_code(result), planish_result_error_where(result),
         planish_result_error_message(result));
  CHECK(write_file(folder, "report.json", planish_result_report(result),
                   strlen(planish_result_report(result))));
  CHECK(write_file(folder, "summary.txt", planish_result_summary(result),
                   strlen(planish_result_summary(result))));
  for (i = 0; i < planish_result_artifact_count(result); ++i) {
    const planish_artifact *one = planish_result_artifact(result, i);
    CHECK(((const char *)one->bytes)[one->size] == '\0');
    printf("%s %s %s\n", one->artifact, one->name, one->media_type);
    CHECK(write_file(folder, one->name, one->bytes, one->size));
  }
  planish_result_free(result);
  return failures != 0;
}

/* ---- all: errors, progress, threads ---- */

/* `where` may be null: anywhere. */
static int is_error(planish_result *result, const char *code, const char *where) {
  const int same = planish_result_status(result) == PLANISH_FAILED &&
                   strcmp(planish_result_error_code(result), code) == 0 &&
                   (!where || strcmp(planish_result_error_where(result), where) == 0) &&
                   planish_result_error_message(result)[0] != '\0' &&
                   planish_result_exit_status(result) != 0 &&
                   planish_result_report(result)[0] == '\0' &&
                   planish_result_artifact_count(result) == 0 &&
                   planish_result_artifact(result, 0) == NULL;
  if (!same)
    fprintf(stderr, "%d %s at %s: %s\n", planish_result_status(result),
            planish_result_error_code(result), planish_result_error_where(result),
            planish_result_error_message(result));
  planish_result_free(result);
  return same;
}

static void check_wrong_requests(void) {
  planish_options options = PLANISH_OPTIONS_INIT;
  char deep[4001];
  CHECK(is_error(planish_run(NULL, NULL), "invalid_input", ""));
  CHECK(is_error(planish_run("{", NULL), "invalid_input", ":1:1"));
  CHECK(is_error(planish_run("\xff\xfe", NULL), "invalid_input", ":1:1"));
  CHECK(is_error(planish_run("[]", NULL), "invalid_input", ""));
  CHECK(is_error(planish_run("{\"maker\": \"unfold\"}", NULL), "invalid_input", "/input"));
  CHECK(is_error(planish_run("{\"maker\": \"fold\", \"input\": \"x\"}", NULL), "invalid_input",
                 "/maker"));
  CHECK(is_error(planish_run("{\"maker\": \"unfold\", \"input\": \"none.step\"}", NULL),
                 "cannot_read", "none.step"));
  memset(deep, '[', sizeof deep - 1);
  deep[sizeof deep - 1] = '\0';
  CHECK(is_error(planish_run(deep, NULL), "invalid_input", ":1:101"));
  options.size = 8;
  CHECK(is_error(planish_run("{}", &options), "bad_option", "planish_options.size"));
  options.size = sizeof options;
  options.where = 7;
  CHECK(is_error(planish_run("{}", &options), "bad_option", "planish_options.where"));
  options.where = PLANISH_APART;
  options.time_limit = -1.0;
  CHECK(is_error(planish_run("{}", &options), "bad_option", "planish_options.time_limit"));
  planish_result_free(NULL);
}

struct heard {
  int calls, most;
  double share;
  char stages[2000];
};

static int hear(void *user, const char *stage, double share) {
  struct heard *heard = user;
  ++heard->calls;
  if (share > heard->share) heard->share = share;
  if (strlen(heard->stages) + strlen(stage) + 2 < sizeof heard->stages) {
    strcat(heard->stages, stage);
    strcat(heard->stages, ";");
  }
  return heard->calls >= heard->most;
}

static void check_progress(const char *bracket, const char *long_request) {
  struct heard heard = {0, 1000000, 0.0, ""};
  planish_options options = PLANISH_OPTIONS_INIT;
  planish_result *result;
  int where;
  options.progress = hear;
  options.user = &heard;
  for (where = PLANISH_APART; where <= PLANISH_HERE; ++where) {
    memset(&heard, 0, sizeof heard);
    heard.most = 1000000;
    options.where = where;
    result = planish_run(bracket, &options);
    CHECK(planish_result_status(result) == PLANISH_OK);
    CHECK(heard.calls > 0 && heard.share > 0.1 && heard.share <= 1.0);
    CHECK(strstr(heard.stages, "finding the sheet") != NULL);
    planish_result_free(result);
    /* Cancelled at the first word, and in the midst of work. */
    memset(&heard, 0, sizeof heard);
    heard.most = 1;
    CHECK(is_error(planish_run(bracket, &options), "cancelled", ""));
    CHECK(heard.calls == 1);
    memset(&heard, 0, sizeof heard);
    heard.most = 12;
    CHECK(is_error(planish_run(long_request, &options), "cancelled", NULL));
    CHECK(heard.calls == 12);
  }
  options.where = PLANISH_APART;
  options.progress = NULL;
  options.time_limit = 0.3;
  result = planish_run(long_request, &options);
  CHECK(strcmp(planish_result_error_code(result), "out_of_time") == 0);
  CHECK(strstr(planish_result_error_message(result), "after 0.3 s") != NULL);
  CHECK(planish_result_exit_status(result) == 4);
  planish_result_free(result);
}

enum { THREADS = 6, ROUNDS = 4 };

struct worker {
  const char *request;
  int where;
  const char *bytes; /* of the first artifact */
  size_t size;
  int wrong;
};

static void *work(void *user) {
  struct worker *worker = user;
  planish_options options = PLANISH_OPTIONS_INIT;
  int round;
  options.where = worker->where;
  for (round = 0; round < ROUNDS; ++round) {
    planish_result *result = planish_run(worker->request, &options);
    const planish_artifact *one = planish_result_artifact(result, 0);
    if (!one || one->size != worker->size || memcmp(one->bytes, worker->bytes, one->size) != 0) {
      ++worker->wrong;
      fprintf(stderr, "thread: %s\n", planish_result_error_message(result));
    }
    if (!planish_schema("report")) ++worker->wrong;
    planish_result_free(result);
  }
  return NULL;
}

/* Some apart, some here, all at once: the same bytes as alone. */
static void check_threads(const char *bracket, const char *plates) {
  pthread_t threads[THREADS];
  struct worker workers[THREADS];
  planish_result *alone[2];
  int i;
  alone[0] = planish_run(bracket, NULL);
  alone[1] = planish_run(plates, NULL);
  for (i = 0; i < THREADS; ++i) {
    const planish_artifact *one = planish_result_artifact(alone[i % 2], 0);
    CHECK(one != NULL);
    if (!one) return;
    workers[i].request = i % 2 ? plates : bracket;
    workers[i].where = i < THREADS / 2 ? PLANISH_APART : PLANISH_HERE;
    workers[i].bytes = one->bytes;
    workers[i].size = one->size;
    workers[i].wrong = 0;
    CHECK(pthread_create(&threads[i], NULL, work, &workers[i]) == 0);
  }
  for (i = 0; i < THREADS; ++i) {
    pthread_join(threads[i], NULL);
    CHECK(workers[i].wrong == 0);
  }
  planish_result_free(alone[0]);
  planish_result_free(alone[1]);
}

static void check_schemas(void) {
  size_t i, count = planish_schema_count();
  CHECK(count >= 10);
  for (i = 0; i < count; ++i) {
    CHECK(planish_schema_name(i) != NULL);
    CHECK(planish_schema(planish_schema_name(i))[0] == '{');
    CHECK(planish_schema(planish_schema_name(i)) == planish_schema(planish_schema_name(i)));
  }
  CHECK(planish_schema_name(count) == NULL);
  CHECK(planish_schema("none") == NULL);
  CHECK(planish_schema(NULL) == NULL);
  CHECK(strstr(planish_catalogue(), "\"unfold\"") != NULL);
}

static int check_all(const char *bracket_file, const char *plates_file, const char *long_file) {
  char *bracket = read_file(bracket_file);
  char *plates = read_file(plates_file);
  char *long_request = read_file(long_file);
  if (!bracket || !plates || !long_request) return 1;
  check_wrong_requests();
  check_schemas();
  check_progress(bracket, long_request);
  check_threads(bracket, plates);
  free(bracket);
  free(plates);
  free(long_request);
  return failures != 0;
}

int main(int argc, char **argv) {
  if (argc == 2 && strcmp(argv[1], "abi") == 0) return print_abi();
  if (argc == 5 && strcmp(argv[1], "run") == 0) return run_request(argv[2], argv[3], argv[4]);
  if (argc == 5 && strcmp(argv[1], "all") == 0) return check_all(argv[2], argv[3], argv[4]);
  fprintf(stderr, "usage: c_interface abi | run REQUEST FOLDER apart|here | all BRACKET PLATES LONG\n");
  return 2;
}
