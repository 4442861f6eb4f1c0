"""
A client of openapi-python-client. Drives forward until a wall is near, and sends the command again,
as after a lost answer. Prints what it received as JSON.
"""

from __future__ import annotations

import json
import sys

from corridor_client import AuthenticatedClient
from corridor_client.api.driving import follow_command, send_command
from corridor_client.models import (
    CommandRecord,
    ForwardOrder,
    GoalUntilCondition,
    Problem,
    SensorUntilCondition,
    SensorUntilConditionIs,
    SensorUntilConditionSensor,
)

origin, robot, key = sys.argv[1:]
client = AuthenticatedClient(base_url=origin, token=key)


def send(order: ForwardOrder) -> CommandRecord | Problem | None:
    return send_command.sync(robot, client=client, body=order, idempotency_key="python-1")


def record_of(answer: CommandRecord | Problem | None) -> CommandRecord:
    assert isinstance(answer, CommandRecord), answer
    return answer


wall = SensorUntilCondition(
    sensor=SensorUntilConditionSensor("front"), is_=SensorUntilConditionIs("<"), than=60
)
near = ForwardOrder(action="forward", until=[wall])
first = record_of(send(near))
again = record_of(send(near))
conflict = send(ForwardOrder(action="forward", until=[GoalUntilCondition(goal=True)]))
assert isinstance(conflict, Problem), conflict
end = record_of(follow_command.sync(robot, first.seq, client=client, wait=25))
print(
    json.dumps(
        {
            "first": first.seq,
            "again": again.seq,
            "duplicate": again.duplicate,
            "conflict": [conflict.status, conflict.type_],
            "end": [end.state, end.distance],
        }
    )
)
