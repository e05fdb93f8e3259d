// A batch with an output of its own: one line of a quotation for each STEP file.
//   own_batch part.step ... > quotation.csv
#include <planish/job/unfold.hpp>

#include <cstdio>

using namespace planish;

int main(int argc, char** argv) {
  int refused = 0;
  std::puts("part;thickness;bends;length;width;cut;area;remark");
  for (int i = 1; i < argc; ++i) {
    job::Request request;
    request.input = argv[i];
    const auto report = job::unfold(request);  // lengths in mm
    if (!report) {
      std::printf("%s;;;;;;;%s\n", argv[i], report.error().message.c_str());
      ++refused;
      continue;
    }
    std::printf("%s;%.4g;%d;%.2f;%.2f;%.2f;%.1f;%s\n", argv[i], report->flat.thickness,
                report->summary.bends, report->size.x(), report->size.y(), report->flat.perimeter,
                report->flat.area, report->has_warnings() ? "see the report" : "");
  }
  return refused > 0 ? 4 : 0;
}
