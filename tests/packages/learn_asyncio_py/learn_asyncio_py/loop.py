import asyncio

from example_interfaces.srv import AddTwoInts
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class AsyncNode(Node):

    def __init__(self):
        super().__init__('async_node')
        self.heard = asyncio.Queue()
        self.create_subscription(String, 'words', self.heard.put_nowait, 10)
        self.words = self.create_publisher(String, 'words', 10)
        self.client = self.create_client(AddTwoInts, 'add_two_ints')
        self.create_service(AddTwoInts, 'add_two_ints', self.add)

    async def add(self, request, response):
        response.sum = request.a + request.b
        return response


async def spin(node):
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        await asyncio.sleep(0.001)


async def talk(node):
    for word in ('one', 'two', 'three'):
        node.words.publish(String(data=word))
        await asyncio.sleep(0.02)


async def listen(node):
    return [(await asyncio.wait_for(node.heard.get(), 10)).data for _ in range(3)]


async def ask(node):
    future = node.client.call_async(AddTwoInts.Request(a=3, b=4))
    while not future.done():
        await asyncio.sleep(0.001)
    return future.result().sum


async def run(node):
    spinning = asyncio.ensure_future(spin(node))
    _, words, total = await asyncio.gather(talk(node), listen(node), ask(node))
    print('words:', words)
    print('sum:', total)
    try:
        await asyncio.wait_for(node.heard.get(), 0.1)
    except asyncio.TimeoutError:
        print('nothing more')
    spinning.cancel()


def main():
    rclpy.init()
    node = AsyncNode()
    asyncio.run(run(node))
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
