/** Outcomes of invalid messages of ROS clients: a close code, or a refusal that their owner reads. */
import type { ScriptList } from "@corridor/protocol";
import { testEndpoints } from "../../testing/bad-input.cases.ts";
import { badTexts, type Attempt, type BadInput, type Outcome } from "../../testing/endpoints.ts";
import { RosClient, type RosConnectOptions } from "../../testing/ros-client.ts";

const MAX_BYTES = 16 * 1024;
const velocity = { op: "publish", topic: "/cmd_vel", msg: { linear: { x: 40 } } };
const goal = { op: "send_action_goal", action: "/move", id: "g", args: { distance: 40 } };

/** Sends a text. The connection ends, or the owner's list of scripts shows the refusal. */
function sending(text: string | Uint8Array): Attempt {
  return async ({ relay, robot }) => {
    const client = await RosClient.connect(relay, robot);
    client.sendText(Buffer.from(text));
    const answered = client.call("/rosapi/nodes").catch(() => null);
    if ((await answered) === null) return closeOutcome(client);
    const list = await relay.ask(robot, "/scripts", { key: robot.ownerKey });
    const { scripts } = (await list.json()) as ScriptList;
    const problem = scripts.find((each) => each.client === "ROS")?.lastProblem ?? null;
    return problem === null
      ? { answer: "accepted", says: "" }
      : { answer: "refused", says: problem.detail };
  };
}

function texts(right: object): Partial<Record<BadInput, Attempt>> {
  const all = badTexts(JSON.stringify(right), MAX_BYTES);
  return Object.fromEntries(all.map(([bad, text]): [BadInput, Attempt] => [bad, sending(text)]));
}

/** Connects otherwise, and is closed. */
function connecting(options: RosConnectOptions, act: (client: RosClient) => void): Attempt {
  return async ({ relay, robot }) => {
    const client = await RosClient.connect(relay, robot, options);
    act(client);
    return closeOutcome(client);
  };
}

async function closeOutcome(client: RosClient): Promise<Outcome> {
  const { code, reason } = await client.closed;
  return { answer: String(code), says: reason };
}

const others: Partial<Record<BadInput, Attempt>> = {
  // A message without a key.
  "wrong order": connecting({ key: null }, (client) => client.send(velocity)),
  "half-closed": connecting({}, (client) => client.halfClose()),
  "a key of another robot": async ({ relay, robot, other }) => {
    const client = await RosClient.connect(relay, robot, { key: null });
    client.send({ op: "auth", mac: other.driverKey });
    return closeOutcome(client);
  },
};

const connection = {
  "too large": "1009 | too large",
  deep: "refused | one JSON object",
  // Unknown fields of an operation are ignored.
  "prototype keys": "accepted",
  NaN: "refused | one JSON object",
  "wrong UTF-8": "1007 | UTF-8",
  "wrong order": "4401 | No key in time",
  // A closed connection receives no response.
  "half-closed": "1006",
  "a key of another robot": "4401 | after the #",
};

testEndpoints({
  "a velocity of a ROS client": {
    attempts: { ...texts(velocity), ...others },
    answers: {
      ...connection,
      Infinity: "refused | linear.x: found",
      // Speeds beyond full power are scaled down.
      "2^53 + 1": "accepted",
      "1e308": "accepted",
    },
  },
  "a goal of a ROS client": {
    attempts: { ...texts(goal), ...others },
    answers: {
      ...connection,
      Infinity: "refused | distance: found",
      "2^53 + 1": "refused | distance: found",
      "1e308": "refused | distance: found",
    },
  },
});
