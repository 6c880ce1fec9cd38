#include "emit/knitted_program.h"

#include "meshknit/emit/emit_program.h"
#include "meshknit/knitout/knitout_writer.h"
#include "meshknit/schedule/schedule_checks.h"
#include "meshknit/verify/verify_knitout.h"

namespace meshknit {

const MachineProfile& shima() {
  static const MachineProfile profile = machine_profile("shima_swg091n2");
  return profile;
}

std::string errors_of_program(const StitchTrace& trace) {
  const Schedule schedule = schedule_stitches(trace, shima());
  const std::string wrong = errors_of(check_schedule(trace, schedule, shima()));
  if (!wrong.empty()) return wrong;
  const std::string text = write_knitout(emit_program(trace, schedule, shima()));
  return errors_of(verify_knitout(text, shima(), trace).problems);
}

}  // namespace meshknit
