/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/WorstMotions.h>
#include <apps/psmks-benchmark/report/WorstPairs.h>
#include <psmks/eval/Jumps.h>
#include <psmks/eval/StampIndex.h>

namespace psmks
{
namespace
{
/** The indices of the scans at both ends of a motion. */
struct Ends
{
  std::size_t from, to;
};

/** The motion of a path between two scans as the result of a match. */
PairRecord recordOf(const std::vector<PosedScan>& path, const Ends& ends, const Pose2& T_from_to)
{
  const PosedScan &from = path[ends.from], &to = path[ends.to];
  const auto betweenSensors = [&](const Pose2& motion)
  { return from.T_robot_sensor.inverse() * motion * to.T_robot_sensor; };
  PairRecord record;
  record.id = static_cast<int>(ends.to);
  record.T_ref_cur_true = betweenSensors(T_from_to);
  record.T_ref_cur_guess = betweenSensors(from.T_world_odometry.inverse() * to.T_world_odometry);
  if (const ReferenceMatch* match = to.decidingMatch()) record.result = match->result;
  record.result.T_ref_cur =
      betweenSensors(from.T_world_robot.pose.inverse() * to.T_world_robot.pose);
  return record;
}
}  // namespace

DrawnRun worstMotions(const std::string& title, const std::vector<PosedScan>& path,
                      const MatchedPath& matched, const std::vector<Relation>& truth,
                      std::size_t count)
{
  const StampIndex index(matched.estimate);
  std::vector<Ends> ends;
  std::vector<PairRecord> records;
  for (const auto& [from_s, to_s, T_from_to] : truth)
  {
    const auto from = index.nearest(from_s, kStampTolerance_s);
    const auto to = index.nearest(to_s, kStampTolerance_s);
    if (!from || !to) continue;
    ends.push_back({matched.scans[*from], matched.scans[*to]});
    records.push_back(recordOf(path, ends.back(), T_from_to));
  }

  DrawnRun worst{title, {}, {}};
  for (const std::size_t place : worstRecords(records, count, kJumpLimit))
  {
    const PairRecord& record = records[place];
    worst.records.push_back(record);
    worst.pairs.push_back({record.id, record.T_ref_cur_true, record.T_ref_cur_guess,
                           path[ends[place].from].scan, path[ends[place].to].scan});
  }
  return worst;
}
}  // namespace psmks
