/** Programs that a file of the service connects, and clients that its description generates. */
import { addressOf, type RobotParts } from "./robot-parts.ts";

export function micromouse(robot: RobotParts): string {
  return `curl -O ${robot.origin}/corridor-cli.mjs
node corridor-cli.mjs mms "${addressOf(robot)}" -- python3 Main.py`;
}

export function viple(robot: RobotParts): string {
  return `curl -O ${robot.origin}/corridor-cli.mjs
node corridor-cli.mjs viple "${addressOf(robot)}"`;
}

export function generated(robot: RobotParts): string {
  return `# First: pip install openapi-python-client
# Then: openapi-python-client generate --meta none --output-path corridor_client --url ${robot.origin}/openapi.json
from corridor_client import AuthenticatedClient
from corridor_client.api.driving import follow_command, send_command
from corridor_client.models import Left90Order, Problem

robot = "${robot.id}"
client = AuthenticatedClient(base_url="${robot.origin}", token="${robot.key}")
command = send_command.sync(robot, client=client, body=Left90Order(action="left 90"))
if not isinstance(command, Problem):
    command = follow_command.sync(robot, command.seq, client=client, wait=25)
print(command.detail if isinstance(command, Problem) else command.reason or command.state)
`;
}
