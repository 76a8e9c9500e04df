#include "daemon/lola_link.h"

#include <gtest/gtest.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <thread>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao::daemon {
namespace {

using boost::asio::local::stream_protocol;

TEST(LolaLink, TakesWholeFramesAndSendsAnswers) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/robocup";
  boost::asio::io_context io;
  stream_protocol::acceptor acceptor(io, stream_protocol::endpoint(path));
  std::string answer(5, '\0');
  std::thread robot([&] {
    stream_protocol::socket socket(io);
    acceptor.accept(socket);
    const std::string frame(LolaLink::kSensorFrame, 'a');
    boost::asio::write(socket, boost::asio::buffer(frame.substr(0, 400)));
    boost::asio::write(socket, boost::asio::buffer(frame.substr(400)));
    boost::asio::read(socket, boost::asio::buffer(answer));
  });
  LolaLink link(path);
  EXPECT_EQ(link.receive(), std::string(LolaLink::kSensorFrame, 'a'));
  link.send("hello");
  robot.join();
  EXPECT_EQ(answer, "hello");
  EXPECT_THROW(link.receive(), InputError);
}

TEST(LolaLink, TellsThatThereIsNoRobot) {
  EXPECT_THROW(LolaLink("/nowhere/robocup"), InputError);
  EXPECT_THROW(LolaLink(std::string(300, 'x')), InputError);
}

}  // namespace
}  // namespace nao::daemon
