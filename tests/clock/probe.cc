// Asks each function of the C library that has to do with time what time passes in it, in a world
// at full speed: probe NAME... prints what did not hold and ends with 1.
#include <linux/futex.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <spawn.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace {

int failures = 0;

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("does not hold: %s\n", what);
  ++failures;
}

// Time that is slept is exactly as long; what goes round the world's cycle is late by less than
// one.
void expectSpan(double from, double span, const char* what) {
  const double passed = now() - from;
  if (std::abs(passed - span) < 1e-6) return;
  std::printf("%s: %.9f s passed, expected %.9f\n", what, passed, span);
  ++failures;
}

timespec in(clockid_t clock, double span) {
  timespec time{};
  clock_gettime(clock, &time);
  const long long at = time.tv_sec * 1000000000LL + time.tv_nsec + std::llround(span * 1e9);
  return {static_cast<time_t>(at / 1000000000), static_cast<long>(at % 1000000000)};
}

void clocks() {
  timeval of_day{};
  gettimeofday(&of_day, nullptr);
  expect(of_day.tv_sec >= 1300000000 && of_day.tv_sec < 1300000010, "the clock starts in 2011");
  expect(time(nullptr) == of_day.tv_sec, "time() is gettimeofday()'s");
  const auto chrono = std::chrono::system_clock::now().time_since_epoch();
  expect(std::chrono::duration_cast<std::chrono::seconds>(chrono).count() == of_day.tv_sec,
         "std::chrono asks the same clock");
}

void sleeps() {
  double from = now();
  usleep(250000);
  expectSpan(from, 0.25, "usleep");
  from = now();
  sleep(3);
  expectSpan(from, 3, "sleep");
  from = now();
  const timespec span{1, 500000000};
  nanosleep(&span, nullptr);
  expectSpan(from, 1.5, "nanosleep");
  from = now();
  const timespec until = in(CLOCK_MONOTONIC, 0.125);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
  expectSpan(from, 0.125, "clock_nanosleep");
  from = now();
  std::this_thread::sleep_for(std::chrono::microseconds(1234567));
  expectSpan(from, 1.234567, "std::this_thread::sleep_for");
}

void descriptors() {
  int ends[2];
  expect(pipe(ends) == 0, "a pipe");
  pollfd asked{ends[0], POLLIN, 0};
  double from = now();
  expect(poll(&asked, 1, 700) == 0, "poll finds nothing");
  expectSpan(from, 0.7, "poll");
  from = now();
  const timespec span{0, 300000000};
  expect(ppoll(&asked, 1, &span, nullptr) == 0, "ppoll finds nothing");
  expectSpan(from, 0.3, "ppoll");
  fd_set set;
  FD_ZERO(&set);
  FD_SET(ends[0], &set);
  timeval time{1, 100000};
  from = now();
  expect(select(ends[0] + 1, &set, nullptr, nullptr, &time) == 0, "select finds nothing");
  expect(!FD_ISSET(ends[0], &set), "select clears its sets");
  expectSpan(from, 1.1, "select");
  const int epoll = epoll_create1(0);
  epoll_event event{};
  event.events = EPOLLIN;
  epoll_ctl(epoll, EPOLL_CTL_ADD, ends[0], &event);
  from = now();
  expect(epoll_wait(epoll, &event, 1, 450) == 0, "epoll_wait finds nothing");
  expectSpan(from, 0.45, "epoll_wait");
  std::thread writer([&] {
    usleep(200000);
    expect(write(ends[1], "x", 1) == 1, "a byte is written");
  });
  from = now();
  char byte = 0;
  expect(read(ends[0], &byte, 1) == 1, "a byte is read");
  expectSpan(from, 0.2, "read waits for another thread");
  writer.join();
  expect(timerfd_create(CLOCK_MONOTONIC, 0) < 0 && errno == EINVAL, "timerfd_create is refused");
  int pair[2];
  expect(socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0, "a pair of sockets");
  const timeval patience{0, 600000};
  setsockopt(pair[0], SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  from = now();
  expect(recv(pair[0], &byte, 1, 0) < 0 && errno == EAGAIN, "recv gives up");
  expectSpan(from, 0.6, "recv with SO_RCVTIMEO");
}

void locks() {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
  bool said = false;
  std::thread holder([&] {
    pthread_mutex_lock(&mutex);
    usleep(400000);
    pthread_mutex_unlock(&mutex);
    usleep(100000);
    pthread_mutex_lock(&mutex);
    said = true;
    pthread_cond_signal(&condition);
    pthread_mutex_unlock(&mutex);
  });
  double from = now();
  usleep(1000);
  pthread_mutex_lock(&mutex);
  expectSpan(from, 0.4, "a lock that somebody has who sleeps");
  while (!said) pthread_cond_wait(&condition, &mutex);
  expectSpan(from, 0.5, "pthread_cond_wait");
  from = now();
  const timespec until = in(CLOCK_REALTIME, 0.8);
  expect(pthread_cond_timedwait(&condition, &mutex, &until) == ETIMEDOUT, "nobody signals");
  expectSpan(from, 0.8, "pthread_cond_timedwait");
  pthread_mutex_unlock(&mutex);
  holder.join();
  sem_t semaphore;
  sem_init(&semaphore, 0, 0);
  from = now();
  const timespec late = in(CLOCK_REALTIME, 0.35);
  expect(sem_timedwait(&semaphore, &late) != 0 && errno == ETIMEDOUT, "nobody posts");
  expectSpan(from, 0.35, "sem_timedwait");
  std::thread poster([&] {
    usleep(50000);
    sem_post(&semaphore);
  });
  from = now();
  sem_wait(&semaphore);
  expectSpan(from, 0.05, "sem_wait");
  poster.join();
  pthread_mutexattr_t checked;
  pthread_mutexattr_init(&checked);
  pthread_mutexattr_settype(&checked, PTHREAD_MUTEX_ERRORCHECK);
  pthread_mutex_t own;
  pthread_mutex_init(&own, &checked);
  pthread_mutex_lock(&own);
  expect(pthread_mutex_lock(&own) == EDEADLK, "who has a lock and asks again is told");
  std::timed_mutex timed;
  timed.lock();
  std::thread waiter([&] {
    const double since = now();
    expect(!timed.try_lock_for(std::chrono::milliseconds(90)), "a timed lock gives up");
    expectSpan(since, 0.09, "std::timed_mutex");
  });
  waiter.join();
  timed.unlock();
}

void futexes() {
  std::promise<int> promise;
  auto future = promise.get_future();
  double from = now();
  expect(future.wait_for(std::chrono::milliseconds(300)) == std::future_status::timeout, "not yet");
  expectSpan(from, 0.3, "std::future::wait_for");
  std::thread setter([&] {
    usleep(150000);
    promise.set_value(7);
  });
  from = now();
  expect(future.get() == 7, "the promise is kept");
  expectSpan(from, 0.15, "std::future::get");
  setter.join();
  static int word = 0;
  const timespec span{0, 250000000};
  from = now();
  expect(syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, 0, &span, nullptr, 0) != 0, "no wake");
  expectSpan(from, 0.25, "syscall(SYS_futex)");
}

volatile sig_atomic_t alarms = 0;

void processes() {
  double from = now();
  const pid_t child = fork();
  if (child == 0) {
    usleep(350000);
    _exit(3);
  }
  int status = 0;
  expect(waitpid(child, &status, 0) == child && WEXITSTATUS(status) == 3, "the child's code");
  expectSpan(from, 0.35, "waitpid");
  from = now();
  pid_t other = 0;
  const char* const words[] = {"sleep", "2", nullptr};
  expect(posix_spawnp(&other, "sleep", nullptr, nullptr, const_cast<char**>(words), environ) == 0,
         "sleep is started");
  waitpid(other, &status, 0);
  expectSpan(from, 2, "another program sleeps");
  from = now();
  expect(system("sleep 1") == 0, "a shell sleeps");
  expectSpan(from, 1, "system waits as long");
  signal(SIGALRM, [](int) { alarms = alarms + 1; });
  const itimerval every{{0, 100000}, {0, 100000}};
  setitimer(ITIMER_REAL, &every, nullptr);
  from = now();
  for (int i = 0; i < 5; ++i) pause();
  expectSpan(from, 0.5, "setitimer and pause");
  expect(alarms == 5, "an alarm each time");
  sigset_t alarm_alone;
  sigemptyset(&alarm_alone);
  sigaddset(&alarm_alone, SIGALRM);
  sigset_t others;
  pthread_sigmask(SIG_BLOCK, &alarm_alone, &others);
  from = now();
  sigsuspend(&others);
  expectSpan(from, 0.1, "sigsuspend");
  pthread_sigmask(SIG_SETMASK, &others, nullptr);
  sigset_t user;
  sigemptyset(&user);
  sigaddset(&user, SIGUSR1);
  const timespec short_time{0, 70000000};
  const itimerval none{};
  setitimer(ITIMER_REAL, &none, nullptr);
  from = now();
  expect(sigtimedwait(&user, nullptr, &short_time) < 0 && errno == EAGAIN, "no signal comes");
  expectSpan(from, 0.07, "sigtimedwait");
  alarm(2);
  from = now();
  expect(sleep(10) == 8, "an alarm ends a sleep and leaves the rest");
  expectSpan(from, 2, "alarm");
}

void spins() {
  double from = now();
  while (now() < from + 2) {
  }
  const double passed = now() - from;
  expect(passed >= 2 && passed < 2.0001, "a loop that looks at the clock comes to its end");
  std::atomic<bool> done{false};
  std::thread other([&] {
    usleep(500000);
    done = true;
  });
  from = now();
  while (!done) std::this_thread::yield();
  expect(now() - from < 0.6, "who yields in a loop waits for another thread");
  other.join();
}

}  // namespace

int main(int argc, char* argv[]) {
  const std::map<std::string, std::function<void()>> all = {
      {"clocks", clocks}, {"sleeps", sleeps},   {"descriptors", descriptors},
      {"locks", locks},   {"futexes", futexes}, {"processes", processes},
      {"spins", spins}};
  for (int i = 1; i < argc; ++i) {
    const auto at = all.find(argv[i]);
    if (at == all.end()) {
      std::printf("%s: no such probe\n", argv[i]);
      return 2;
    }
    at->second();
  }
  std::printf("%d probes, %d failures\n", argc - 1, failures);
  return failures == 0 ? 0 : 1;
}
