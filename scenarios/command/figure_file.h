// How a run's energy, momenta and contacts went, as a picture.
#pragma once

#include <string>

#include "ballpark/scenes.h"
#include "scenarios/command/output_file.h"
#include "scenarios/view/history.h"

namespace ballpark::command {

class FigureFile {
 public:
  /// Throws UsageError or DestinationError. The scene must outlive this. `ledger`: with that of
  /// the world.
  FigureFile(const std::string& path, const Scene& scene, bool ledger);
  /// When add() wants to be called.
  scenes::OutputRequest request() const;
  void add(const World& world);
  void write();  ///< throws WriteError
  const std::string& path() const { return file_.path(); }

 private:
  const Scene& scene_;
  OutputFile file_;
  view::History history_;
  std::string setting_;  ///< of the world
};

}  // namespace ballpark::command
