// What the smallest user of an installed planish looks like.
#include <planish/job/unfold.hpp>

#include <cstdio>

int main(int, char** argv) {
  planish::job::Request request;
  request.input = argv[1];
  const auto report = planish::job::unfold(request);
  if (!report) return std::puts(report.error().message.c_str()), 1;
  std::printf("flat: %.2f x %.2f mm\n", report->size.x(), report->size.y());
}
