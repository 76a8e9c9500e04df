#pragma once

namespace CLI {
class App;
}

namespace nao::app {

/// Each adds one subcommand to the program; it runs while the command line is parsed.
void addServe(CLI::App& app);
void addRun(CLI::App& app);
void addExperiment(CLI::App& app);
void addEffects(CLI::App& app);
void addDescribe(CLI::App& app);
void addPlay(CLI::App& app);
void addCheckData(CLI::App& app);
void addConvert(CLI::App& app);
void addRecord(CLI::App& app);
void addDiagnose(CLI::App& app);
void addCatalog(CLI::App& app);
void addExtend(CLI::App& app);
void addGain(CLI::App& app);
void addReplay(CLI::App& app);
void addOptimise(CLI::App& app);
void addPlan(CLI::App& app);
void addBench(CLI::App& app);
void addHide(CLI::App& app);
void addRender(CLI::App& app);
void addCi(CLI::App& app);

}  // namespace nao::app
