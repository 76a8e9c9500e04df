"""Where callbacks run: threads that are made when all are busy, and that end with the program."""

import heapq
import itertools
import threading
import time
import traceback
from collections import deque
from typing import Any, Callable

IDLE_LIFETIME = 10.0  # s; a thread that waited so long for work ends


class Pool:
    """Runs jobs at once, each on a thread of its own; no job waits for another's end."""

    def __init__(self, name: str):
        self._name = name
        self._changed = threading.Condition()
        self._jobs: deque = deque()
        self._idle = 0

    def run(self, job: Callable[[], Any]) -> None:
        with self._changed:
            self._jobs.append(job)
            if self._idle >= len(self._jobs):
                self._changed.notify()
                return
        threading.Thread(target=self._work, name=self._name, daemon=True).start()

    def _work(self) -> None:
        while True:
            job = self._take()
            if job is None:
                return
            runSafely(job)

    def _take(self) -> Any:
        with self._changed:
            self._idle += 1
            found = self._changed.wait_for(lambda: self._jobs, IDLE_LIFETIME)
            self._idle -= 1
            return self._jobs.popleft() if found else None


class Strand:
    """Runs jobs one after the other, in the order in which they came."""

    def __init__(self, pool: Pool):
        self._pool = pool
        self._lock = threading.Lock()
        self._jobs: deque = deque()
        self._running = False

    def run(self, job: Callable[[], Any]) -> None:
        with self._lock:
            self._jobs.append(job)
            if self._running:
                return
            self._running = True
        self._pool.run(self._work)

    def _work(self) -> None:
        while True:
            with self._lock:
                if not self._jobs:
                    self._running = False
                    return
                job = self._jobs.popleft()
            runSafely(job)


class Timer:
    """Hands jobs to the pool when their time has come."""

    def __init__(self, pool: Pool):
        self._pool = pool
        self._changed = threading.Condition()
        self._due: list = []
        self._order = itertools.count()
        self._started = False

    def runAfter(self, seconds: float, job: Callable[[], Any]) -> None:
        with self._changed:
            heapq.heappush(self._due, (time.monotonic() + seconds, next(self._order), job))
            if not self._started:
                self._started = True
                threading.Thread(target=self._work, name="qi timer", daemon=True).start()
            self._changed.notify()

    def _work(self) -> None:
        while True:
            with self._changed:
                now = time.monotonic()
                if not self._due or self._due[0][0] > now:
                    self._changed.wait(self._due[0][0] - now if self._due else None)
                    continue
                _, _, job = heapq.heappop(self._due)
            self._pool.run(job)


def runSafely(job: Callable[[], Any]) -> None:
    try:
        job()
    except Exception:  # pylint: disable=broad-except  # the job's own mistake: shown, and on it goes
        traceback.print_exc()


callbacks = Pool("qi callback")
timer = Timer(callbacks)
