"""Drive a robot from your own script: `from corridor import Robot; robot = Robot(ADDRESS)`."""

from .async_robot import AsyncRobot
from .errors import (
    AddressError,
    ClosedError,
    CommandEndedError,
    CommandError,
    NoAnswerError,
    NoMazeError,
    NotAuthorisedError,
    PairingError,
    RobotError,
    RobotGoneError,
)
from .live_sensor import LiveSensor
from .reports import Cell, Command, Event, Maze, Pose, Sensors, Snapshot, Start
from .robot import Robot
from .uncaught import explain_uncaught

__all__ = [
    "AddressError",
    "AsyncRobot",
    "Cell",
    "ClosedError",
    "Command",
    "CommandEndedError",
    "CommandError",
    "Event",
    "LiveSensor",
    "Maze",
    "NoAnswerError",
    "NoMazeError",
    "NotAuthorisedError",
    "PairingError",
    "Pose",
    "Robot",
    "RobotError",
    "RobotGoneError",
    "Sensors",
    "Snapshot",
    "Start",
]
__version__ = "0.1.0"

explain_uncaught()
