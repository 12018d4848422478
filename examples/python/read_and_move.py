"""Reads, writes and moves a robot from Python, by the classes of jopenshowvar.jar.

    python read_and_move.py [--jar JAR] [HOST PORT]

HOST PORT name a controller in which FOLLOW_AXIS (krl/follow_axis.src) runs: WITH THEM IT MOVES
THAT ROBOT, A1 by 3 degrees. Begin in T1, with a hand on the enabling switch. Without them a
simulated controller is started. It needs Java 17 and what requirements.txt names.
"""

import argparse
import pathlib
import sys

import jpype

PROJECT = pathlib.Path(__file__).resolve().parents[2]


def main():
    parser = argparse.ArgumentParser(description="Reads, writes and moves a robot.")
    parser.add_argument(
        "--jar",
        default=PROJECT / "src/cli/target/jopenshowvar.jar",
        help="the jar, or a class path; by default the one that the build makes",
    )
    parser.add_argument("host", nargs="?")
    parser.add_argument("port", nargs="?", type=int)
    arguments = parser.parse_args()
    if (arguments.host is None) != (arguments.port is None):
        parser.error("HOST and PORT belong together")

    # convertStrings: a java.lang.String comes as a str
    jpype.startJVM(classpath=[str(arguments.jar)], convertStrings=True)
    if arguments.host is not None:
        run(arguments.host, arguments.port)
        return
    robot = jpype.JClass("no.hials.crosscom.mock.MockServer").start()
    try:
        start_program(robot.controller())
        run(robot.host(), robot.port())
    finally:
        robot.close()


def start_program(controller):
    """Loads and starts the program that moves the simulated robot."""
    path = jpype.JClass("java.nio.file.Path")
    controller.load(path.of(str(PROJECT / "krl/config.dat")))
    program = controller.load(path.of(str(PROJECT / "krl/follow_axis.src")))
    controller.robot().select(program)
    controller.runProgram()


def run(host, port):
    client = jpype.JClass("no.hials.crosscom.CrossComClient")(host, port)
    try:
        print("mode", client.readText("$MODE_OP"))
        print("A1 to A6 in degrees:", list(client.readJointAngles()))
        client.writeInt("$OV_PRO", 50)
        print("override in %:", client.readInt("$OV_PRO"))
        refused(client)
        move(client)
    finally:
        client.close()


def refused(client):
    """Shows that a Java exception is a Python exception; it names the variable."""
    access_exception = jpype.JClass("no.hials.crosscom.CrossComAccessException")
    try:
        client.readText("NO_SUCH_VARIABLE")
    except access_exception as e:
        print("refused:", e.getVariable())


def move(client):
    while client.readText("JOV_AXIS") != client.readText("$AXIS_ACT"):
        check_active(client)  # until the program's target is where the robot stands
    target = client.readReal("JOV_AXIS.A1") + 3
    client.writeReal("JOV_AXIS.A1", target)  # moves a machine
    while abs(client.readReal("$AXIS_ACT.A1") - target) > 0.01:
        check_active(client)
    print(f"A1 is at {client.readReal('$AXIS_ACT.A1'):.1f} degrees")


def check_active(client):
    state = client.readText("$PRO_STATE1")
    if state != "#P_ACTIVE":
        sys.exit(f"the program must be active, is {state}")


if __name__ == "__main__":
    main()
