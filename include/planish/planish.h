/*
 * The C interface of Planish: a request as JSON in, a report and files out. C99; no C++ is needed.
 *
 *   planish_result *result = planish_run(
 *       "{\"maker\": \"unfold\", \"input\": \"part.step\", \"artifacts\": [\"dxf\"]}", NULL);
 *   if (planish_result_status(result) < PLANISH_REFUSED) {
 *     const planish_artifact *dxf = planish_result_artifact(result, 0);
 *     fwrite(dxf->bytes, 1, dxf->size, file);
 *   } else {
 *     fprintf(stderr, "%s\n", planish_result_error_message(result));
 *   }
 *   planish_result_free(result);
 *
 * Ownership. A result belongs to the caller, who frees it once. What functions return that take a
 * result belongs to that result and lives as long; all other texts live as long as the process.
 *
 * Text. All text is UTF-8, ends with a null byte, and is never a null pointer unless that is said.
 *
 * Errors. Whatever happens is a result with a status; no exception leaves the library, no input
 * ends the process (with PLANISH_APART), and nothing is printed.
 *
 * Threads. Every function may be called from any thread, planish_run from several at a time. A
 * result may be read by several threads, and freed by one when the others are done.
 *
 * Processes. With PLANISH_APART a request runs in a copy of this process (fork), which ends with
 * it. Other threads may go on meanwhile; only what other code than this library's does with Planish
 * or OpenCASCADE in this process must not be in the midst of work when planish_run is called. Linux
 * alone.
 *
 * Compatibility. A program built with this header runs with every libplanish.so of the same
 * PLANISH_ABI, which is the number in its soname: functions and members are only ever added.
 */
#ifndef PLANISH_PLANISH_H
#define PLANISH_PLANISH_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define PLANISH_API __attribute__((visibility("default")))
#else
#define PLANISH_API
#endif

/* The version of this interface; planish_abi() is that of the library that is loaded. */
#define PLANISH_ABI 1

/* What became of a request. Below PLANISH_REFUSED there is a flat pattern. */
enum {
  PLANISH_OK = 0,
  PLANISH_WARNING = 1, /* made, and the report has warnings */
  PLANISH_REFUSED = 2, /* the input is understood, but has no flat pattern: there is a report */
  PLANISH_FAILED = 3   /* the request or its input is wrong, or the work was ended: no report */
};

/* Where a request runs. */
enum {
  PLANISH_APART = 0, /* in a copy of this process, with limits: it may crash */
  PLANISH_HERE = 1   /* in this process, without limits: a file that crashes the CAD kernel ends it */
};

typedef struct planish_result planish_result;

/*
 * Hears how far a request is, and says whether it shall go on: 0, or anything else to cancel it.
 * Called in the thread of planish_run, with each new stage ("reading") and share (0 to 1), and
 * about every 50 ms with the last ones ("" and 0 before the first). It must return, neither by an
 * exception nor by longjmp, and must not call planish_run. `user` is that of the options.
 */
typedef int (*planish_progress)(void *user, const char *stage, double share);

/* How a request runs. Begin with PLANISH_OPTIONS_INIT; 0 is the default of every member. */
typedef struct planish_options {
  size_t size;           /* sizeof(planish_options) */
  int32_t where;         /* PLANISH_APART or PLANISH_HERE */
  int32_t reserved;      /* 0 */
  double time_limit;     /* seconds, of PLANISH_APART; 0: 120 */
  uint64_t memory_limit; /* bytes beyond those of this process, of PLANISH_APART; 0: 4 GiB;
                            UINT64_MAX: none */
  planish_progress progress; /* may be null */
  void *user;
} planish_options;

#define PLANISH_OPTIONS_INIT \
  { sizeof(planish_options), PLANISH_APART, 0, 0.0, 0, NULL, NULL }

/* A file that a request asked for, in memory. */
typedef struct planish_artifact {
  const char *artifact;   /* as the request calls it: "dxf" */
  const char *name;       /* "part.dxf" */
  const char *media_type; /* "image/vnd.dxf" */
  const void *bytes;      /* followed by a null byte that does not count */
  size_t size;
} planish_artifact;

/* The version of the library, "0.1.0", and that of its interface, PLANISH_ABI. */
PLANISH_API const char *planish_version(void);
PLANISH_API int planish_abi(void);

/*
 * Runs a request: the text of a JSON object (planish_schema("request"), docs/cli.md#requests).
 * `options` may be null. Never returns a null pointer.
 */
PLANISH_API planish_result *planish_run(const char *request, const planish_options *options);

/* Frees a result and all that belongs to it; a null pointer is left alone. */
PLANISH_API void planish_result_free(planish_result *result);

/* PLANISH_OK and so on. */
PLANISH_API int planish_result_status(const planish_result *result);

/* The report as JSON (planish_schema("report"); of maker "info", planish_schema("info")); "" if
   there is none. */
PLANISH_API const char *planish_result_report(const planish_result *result);

/* The same in some lines for people; "" if there is none. */
PLANISH_API const char *planish_result_summary(const planish_result *result);

/*
 * Why a request failed or was refused, all "" otherwise: a code for programs ("not_a_sheet",
 * docs/formats.md#reason), a sentence for people with numbers, units and the remedy, and the place:
 * a JSON pointer in the request ("/options/k"), or one behind the name of the input, or a face or
 * bend; "" where the whole input is meant.
 */
PLANISH_API const char *planish_result_error_code(const planish_result *result);
PLANISH_API const char *planish_result_error_message(const planish_result *result);
PLANISH_API const char *planish_result_error_where(const planish_result *result);

/* The status with which the program planish would end: 0 to 4 (docs/cli.md). */
PLANISH_API int planish_result_exit_status(const planish_result *result);

/* The files, numbered from 0; a null pointer for a number that there is not. */
PLANISH_API size_t planish_result_artifact_count(const planish_result *result);
PLANISH_API const planish_artifact *planish_result_artifact(const planish_result *result,
                                                            size_t number);

/* The names of all schemas, numbered from 0; a null pointer for a number that there is not. */
PLANISH_API size_t planish_schema_count(void);
PLANISH_API const char *planish_schema_name(size_t number);

/* A JSON Schema (draft 2020-12); a null pointer for an unknown name. */
PLANISH_API const char *planish_schema(const char *name);

/* Makers and artifacts as JSON: {"makers": [...], "artifacts": [...]}. */
PLANISH_API const char *planish_catalogue(void);

#ifdef __cplusplus
}
#endif

#endif
