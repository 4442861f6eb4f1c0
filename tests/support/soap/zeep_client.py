"""A SOAP client in Python, generated from the running service. It drives a square.

    python zeep_client.py WSDL ADDRESS OTHER_ADDRESS

Drives the robot with its key in the address, and the other robot with its key in the header.
Prints one line of JSON: what it received.
"""

import json
import sys

import requests
import zeep
import zeep.helpers
from zeep.transports import Transport


def plain(value):
    """A result as JSON. Times are texts."""
    return json.loads(json.dumps(zeep.helpers.serialize_object(value, dict), default=str))


def square(service, robot, key):
    """Drives forward and turns right, four times."""
    records = []
    for side in range(4):
        for action, fields in (("move", {"distance": 100}), ("right 90", {})):
            record = service.Command(
                robot=robot, action=action, key=f"{key}-{side}-{action[0]}", wait=25, **fields
            )
            records.append(plain(record))
    return records


def fault(call, client):
    """The code of a fault and its typed detail."""
    try:
        call()
    except zeep.exceptions.Fault as error:
        kind = client.get_element("{urn:corridor:robot:1}RobotFault")
        return {
            "code": error.code,
            "message": error.message,
            "detail": plain(kind.parse(find(error.detail, "RobotFault"), client.wsdl.types)),
        }
    raise SystemExit("no fault")


def find(detail, name):
    """The element in the detail. SOAP 1.1 returns the detail, SOAP 1.2 its parent as well."""
    return next(each for each in detail.iter() if each.tag.endswith("}" + name))


def main():
    wsdl, robot, other = sys.argv[1:]
    settings = zeep.Settings(strict=True, forbid_entities=True, forbid_external=True)
    client = zeep.Client(wsdl, settings=settings)
    service = client.service
    far = {"sensor": "front", "is": "<=", "than": "60"}
    found = {
        "sense": plain(service.Sense(robot=robot)),
        "square": square(service, robot, "square-1"),
        "until": plain(
            service.Command(robot=robot, action="forward", until=[far, {"goal": True}], wait=25)
        ),
        "log": plain(service.GetCommands(robot=robot)),
        "one": plain(service.GetCommand(robot=robot, seq=1)),
        "stop": plain(service.Stop(robot=robot, wait=25)),
        "wrong": fault(
            lambda: service.Command(robot=robot, action="move", distance=90000), client
        ),
        "gone": fault(lambda: service.GetCommand(robot=robot, seq=1000), client),
    }
    address, key = other.split("#")
    session = requests.Session()
    session.headers["Authorization"] = f"Bearer {key}"
    by_header = zeep.Client(wsdl, transport=Transport(session=session), settings=settings)
    found["other"] = square(by_header.service, address, "square-2")
    found["sensed"] = plain(by_header.service.Sense(robot=address))
    print(json.dumps(found), flush=True)


main()
