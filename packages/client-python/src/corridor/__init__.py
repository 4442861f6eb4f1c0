"""Drive a robot from your own script: `from corridor import Robot; robot = Robot(ADDRESS)`."""

from .async_robot import AsyncRobot
from .errors import (
    AddressError,
    ClosedError,
    CommandEndedError,
    CommandError,
    NoAnswerError,
    NotAuthorisedError,
    PairingError,
    RobotError,
    RobotGoneError,
)
from .reports import Command, Pose, Sensors, Snapshot
from .robot import Robot

__all__ = [
    "AddressError",
    "AsyncRobot",
    "ClosedError",
    "Command",
    "CommandEndedError",
    "CommandError",
    "NoAnswerError",
    "NotAuthorisedError",
    "PairingError",
    "Pose",
    "Robot",
    "RobotError",
    "RobotGoneError",
    "Sensors",
    "Snapshot",
]
__version__ = "0.1.0"
