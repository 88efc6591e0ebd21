"""One command in a process of its own, with limits of time and memory, and what it used."""
import os
import signal
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass

GIB = 1 << 30
POLL_SECONDS = 0.05
REASON_LENGTH = 200


@dataclass(frozen=True)
class Limits:
    seconds: float = 120
    memory: int = 4 * GIB  # bytes, of the process and its children together


@dataclass(frozen=True)
class Outcome:
    status: str  # ok, timeout, memory, failed
    reason: str  # empty if ok
    seconds: float  # wall clock
    memory: int  # bytes, the peak of the resident set
    output: str = ""  # standard output

    @property
    def ok(self):
        return self.status == "ok"


def resident_bytes(group):
    """Resident set of every process of a process group, from /proc; 0 where there is none."""
    total = 0
    for entry in os.scandir("/proc"):
        if not entry.name.isdigit():
            continue
        try:
            with open(f"/proc/{entry.name}/stat", encoding="ascii", errors="replace") as stat:
                fields = stat.read().rpartition(")")[2].split()
        except OSError:
            continue  # it has ended
        if int(fields[2]) == group:
            total += int(fields[21]) * os.sysconf("SC_PAGE_SIZE")
    return total


class Watch(threading.Thread):
    """Kills a process group that outgrows its limits, and says why."""

    def __init__(self, process, limits):
        super().__init__(daemon=True)
        self.process, self.limits, self.verdict, self.peak = process, limits, None, 0
        self.done = threading.Event()

    def run(self):
        begin = time.monotonic()
        while not self.done.wait(POLL_SECONDS):
            self.peak = max(self.peak, resident_bytes(self.process.pid))
            if time.monotonic() - begin > self.limits.seconds:
                self.verdict = ("timeout", f"more than {self.limits.seconds:g} s")
            elif self.peak > self.limits.memory:
                self.verdict = ("memory", f"more than {self.limits.memory / GIB:g} GiB")
            if self.verdict:
                kill_group(self.process.pid)
                return


RUNNING = set()  # process groups; for an end before their time


def kill_all():
    """Ends every command that runs in any thread: their outcomes are not to be believed."""
    for group in tuple(RUNNING):
        kill_group(group)


def kill_group(group):
    try:
        os.killpg(group, signal.SIGKILL)
    except ProcessLookupError:
        pass


def last_line(text):
    """What a program says at its end; arris adds a remedy, which is no reason."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    lines = [line for line in lines if not line.startswith("remedy:")]
    return lines[-1][:REASON_LENGTH] if lines else ""


def run(command, limits=Limits(), directory=None):
    """Runs the command; never raises for what the command does."""
    with tempfile.TemporaryFile("w+", errors="replace") as out, \
            tempfile.TemporaryFile("w+", errors="replace") as err:
        begin = time.monotonic()
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                       cwd=directory, start_new_session=True)
        except OSError as error:
            return Outcome("failed", str(error), 0, 0)
        RUNNING.add(process.pid)
        watch = Watch(process, limits)
        watch.start()
        try:
            _, wait_status, usage = os.wait4(process.pid, 0)
        except BaseException:  # Ctrl-C must not leave the command behind
            kill_group(process.pid)
            raise
        finally:
            RUNNING.discard(process.pid)
            watch.done.set()
            watch.join()
        seconds = time.monotonic() - begin
        process.returncode = os.waitstatus_to_exitcode(wait_status)
        out.seek(0)
        err.seek(0)
        peak = max(usage.ru_maxrss * 1024, watch.peak)
        if watch.verdict:
            return Outcome(*watch.verdict, seconds, peak)
        if process.returncode < 0:
            name = signal.Signals(-process.returncode).name
            return Outcome("failed", f"ended by {name}", seconds, peak)
        if process.returncode > 0:
            reason = last_line(err.read()) or f"exit code {process.returncode}"
            return Outcome("failed", reason, seconds, peak)
        return Outcome("ok", "", seconds, peak, out.read())
