"""Shows the robots of a gateway over OPC UA, and writes the override of the first one.

usage: opcua_robots.py URL [USER PASSWORD]
"""

import asyncio
import sys

from asyncua import Client, ua

ROBOTS = "urn:jopenshowvar:gateway:robots"
ROBOTICS = "http://opcfoundation.org/UA/Robotics/"
DI = "http://opcfoundation.org/UA/DI/"
MOTION_DEVICE_SYSTEM_TYPE = 1002
AXIS_TYPE = 16601


async def of_type(node, type_id):
    """Returns the nodes below a node that are of a type."""
    found = []
    for reference in await node.get_references(ua.ObjectIds.HierarchicalReferences, ua.BrowseDirection.Forward):
        if reference.TypeDefinition == type_id:
            found.append(reference)
    return found


async def value(client, namespace, identifier):
    """Returns a value, or the name of the status if there is none."""
    data = await client.get_node(ua.NodeId(identifier, namespace)).read_data_value(raise_on_bad_status=False)
    return data.Value.Value if data.StatusCode.is_good() else data.StatusCode.name


class Changes:
    """Receives what the server sends of a subscription."""

    def __init__(self):
        self.queue = asyncio.Queue()

    def datachange_notification(self, node, value, data):
        self.queue.put_nowait(value)

    async def wait_for(self, expected):
        while await asyncio.wait_for(self.queue.get(), 20) != expected:
            pass


async def main(url, user=None, password=None):
    client = Client(url)
    if user:
        client.set_user(user)
        client.set_password(password)
    async with client:
        robots = await client.get_namespace_index(ROBOTS)
        robotics = await client.get_namespace_index(ROBOTICS)
        devices = client.get_node(ua.NodeId(5001, await client.get_namespace_index(DI)))
        systems = await of_type(devices, ua.NodeId(MOTION_DEVICE_SYSTEM_TYPE, robotics))
        for system in systems:
            name = system.BrowseName.Name
            state = f"{name}/SafetyStates/SafetyState/ParameterSet/"
            axes = client.get_node(ua.NodeId(f"{name}/MotionDevices/Robot/Axes", robots))
            positions = []
            for axis in await of_type(axes, ua.NodeId(AXIS_TYPE, robotics)):
                path = f"{axis.NodeId.Identifier}/ParameterSet/ActualPosition"
                position = await value(client, robots, path)
                # without a value, it is the name of the status
                positions.append(position if isinstance(position, str) else f"{position:.1f}")
            print(name, "mode", await value(client, robots, state + "OperationalMode"), "axes", *positions)

        override = client.get_node(ua.NodeId(f"{systems[0].BrowseName.Name}:$OV_PRO", robots))
        changes = Changes()
        subscription = await client.create_subscription(100, changes)
        await subscription.subscribe_data_change(override)
        print("override", await asyncio.wait_for(changes.queue.get(), 20))
        try:
            await override.write_value(50, ua.VariantType.Int32)
            await changes.wait_for(50)
            print("override is now 50")
        except ua.UaStatusCodeError as refused:
            print("not written:", type(refused).__name__)


asyncio.run(main(*sys.argv[1:]))
