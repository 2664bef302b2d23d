/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/TableOutput.h>

#include <iostream>

namespace psmks
{
void TableOutput::write(const std::vector<Table>& tables)
{
  print(tables);
  save(tables);
}

void TableOutput::print(const std::vector<Table>& tables)
{
  std::cout << Machine::present().line() << '\n';
  for (const auto& table : tables) std::cout << '\n' << toText(table);
}

void TableOutput::save(const std::vector<Table>& tables)
{
  const Machine machine = Machine::present();
  const TableOrigin origin{"machine",
                           "Measured on: " + machine.line(),
                           {{"processor", machine.processor},
                            {"compiler", machine.compiler},
                            {"flags", machine.flags},
                            {"build_type", machine.buildType},
                            {"commit", machine.commit}}};
  files_.save(tables, &origin);
}
}  // namespace psmks
