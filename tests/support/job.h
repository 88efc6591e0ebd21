// A running job for tests of single rooms: one stage that is the whole of it, nobody listening.
#pragma once

#include "arris/context.h"
#include "base/job.h"

namespace arris::test {

class OneStageJob {
 public:
  explicit OneStageJob(unsigned threads = 1) {
    context_.threads = threads;
    job_.stage("test", 1);
  }
  operator Job&() { return job_; }

 private:
  Context context_;
  Job job_{context_};
};

}  // namespace arris::test
