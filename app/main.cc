#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.h"
#include "core/check.h"

// Exit codes: 0 done, 1 something failed on the way, 2 the user asked for something impossible,
// 3 a motion was played, but parts of its file could not be read, 10 to 13 a diagnosis did not end
// with "no discrepancy" (validation/diagnosis/causes/verdict.h), 20 recorded data have faults.
// `run` ends with the exit code of its program.
int main(int argc, char** argv) {
  CLI::App app("UsarNaoQi: a simulated Nao that speaks the Nao's own protocols.", "usarnaoqi");
  app.require_subcommand(1);
  app.footer("Start with:  usarnaoqi serve      then connect any NaoQi client to 127.0.0.1:9559.");
  nao::app::addServe(app);
  nao::app::addRun(app);
  nao::app::addExperiment(app);
  nao::app::addEffects(app);
  nao::app::addDescribe(app);
  nao::app::addPlay(app);
  nao::app::addCheckData(app);
  nao::app::addConvert(app);
  nao::app::addRecord(app);
  nao::app::addDiagnose(app);
  nao::app::addCatalog(app);
  nao::app::addExtend(app);
  nao::app::addGain(app);
  nao::app::addReplay(app);
  nao::app::addOptimise(app);
  nao::app::addPlan(app);
  nao::app::addBench(app);
  nao::app::addHide(app);
  nao::app::addRender(app);
  nao::app::addCi(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  } catch (const nao::InputError& error) {
    std::fprintf(stderr, "usarnaoqi: %s\n", error.what());
    return 2;
  }
}
