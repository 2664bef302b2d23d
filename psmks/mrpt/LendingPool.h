/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace psmks
{
/** Objects that are expensive to make and serve one thread at a time. Several threads may borrow at
 *  once; each gets its own object, a new one only where all others are lent. A copied pool is
 *  empty: it shares nothing with its original. */
template <class T>
class LendingPool
{
 public:
  LendingPool() = default;
  LendingPool(const LendingPool&) : LendingPool() {}
  LendingPool& operator=(const LendingPool&) { return *this; }

  /** An object that goes back to its pool in the end. It must not outlive the pool. */
  class Loan
  {
   public:
    explicit Loan(LendingPool& pool) : pool_(pool), object_(pool.take()) {}
    ~Loan() { pool_.giveBack(std::move(object_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    T& operator*() { return *object_; }

   private:
    LendingPool& pool_;
    std::unique_ptr<T> object_;
  };

 private:
  std::unique_ptr<T> take()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (idle_.empty()) return std::make_unique<T>();
    std::unique_ptr<T> object = std::move(idle_.back());
    idle_.pop_back();
    return object;
  }

  void giveBack(std::unique_ptr<T> object)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(object));
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> idle_;
};
}  // namespace psmks
