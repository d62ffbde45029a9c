// Compatibility, works: Boost 1.74 as far as it is headers (`boost`, `libboost-dev`,
// `find_package(Boost)`), so nearly all of it: containers, strings, graphs, geometry, odeint,
// date_time, property trees, lock-free queues, signals

// Compatibility, cannot: Boost's compiled libraries (filesystem, program_options, regex,
// serialization, thread and others) -> R2W0503 with the component; std::filesystem, std::regex and
// std::thread work

// Compatibility, cannot: Boost.Asio, Beast, Process, Python, MPI, Compute, Context, Coroutine,
// Fiber, Log and Wave -> R2W0502, since no such header is there: a site has no sockets, processes
// or stacks beside its own

#include <boost/algorithm/string.hpp>
#include <boost/circular_buffer.hpp>
#include <boost/date_time/gregorian/gregorian.hpp>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/lexical_cast.hpp>
#include <boost/lockfree/spsc_queue.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <boost/system/error_code.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expect.hpp"

namespace {

void check_values(Expectations& expectations) {
  boost::circular_buffer<int> last(3);
  for (int i = 0; i < 5; ++i) last.push_back(i);
  EXPECT(last.front() == 2 && last.back() == 4 && last.full());
  std::vector<std::string> words;
  boost::split(words, "base_link,odom,map", boost::is_any_of(","));
  EXPECT(words.size() == 3 && boost::to_upper_copy(words[1]) == "ODOM");
  EXPECT(boost::lexical_cast<double>("2.5") == 2.5);
  EXPECT_THROWS(boost::bad_lexical_cast, boost::lexical_cast<int>("two"));
  EXPECT(near(boost::math::quantile(boost::math::normal(), 0.975), 1.959963984540054));
  EXPECT(boost::system::errc::make_error_code(boost::system::errc::timed_out).value() == ETIMEDOUT);
}

void check_dates(Expectations& expectations) {
  using namespace boost::gregorian;
  const date day = from_simple_string("2024-Feb-28") + days(2);
  EXPECT(to_iso_extended_string(day) == "2024-03-01" && day.day_of_week() == Friday);
}

void check_paths(Expectations& expectations) {
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, double>>;
  Graph graph(4);
  boost::add_edge(0, 1, 1.0, graph);
  boost::add_edge(1, 2, 2.5, graph);
  boost::add_edge(0, 2, 4.0, graph);
  boost::add_edge(2, 3, 1.0, graph);
  std::vector<double> lengths(4);
  boost::dijkstra_shortest_paths(graph, boost::vertex(0, graph),
                                 boost::distance_map(lengths.data()));
  EXPECT(near(lengths[2], 3.5) && near(lengths[3], 4.5));
}

void check_messages(Expectations& expectations) {
  boost::property_tree::ptree tree;
  std::istringstream text(R"({"robot": {"wheels": [{"radius": 0.05}], "name": "r2"}})");
  boost::property_tree::read_json(text, tree);
  EXPECT(tree.get<std::string>("robot.name") == "r2");
  EXPECT(near(tree.get_child("robot.wheels").front().second.get<double>("radius"), 0.05));
  EXPECT_THROWS(boost::property_tree::ptree_bad_path, tree.get<int>("robot.arms"));

  boost::lockfree::spsc_queue<int, boost::lockfree::capacity<64>> queue;
  int sum = 0;
  for (int i = 1; i <= 1000; ++i) {
    while (!queue.push(i)) queue.consume_all([&](int value) { sum += value; });
  }
  queue.consume_all([&](int value) { sum += value; });
  EXPECT(sum == 500500);
}

}  // namespace

void check_boost(Expectations& expectations) {
  check_values(expectations);
  check_dates(expectations);
  check_paths(expectations);
  check_messages(expectations);
}
