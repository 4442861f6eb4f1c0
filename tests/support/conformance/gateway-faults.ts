/** Faults in gateways, and the check that must catch each. */
import { valueAt } from "../../../packages/conformance/src/mismatch.ts";
import type { GatewayFault, HttpMessage } from "./gateway-proxy.ts";

interface InjectedGatewayFault extends GatewayFault {
  fault: string;
  /** the promise whose check must fail */
  caughtBy: string;
}

type Frame = Record<string, unknown>;

/** Changes frames for which the condition holds. */
function frames(fits: (frame: Frame) => boolean, change: (frame: Frame) => object | null) {
  return (text: string): string => {
    const frame = JSON.parse(text) as Frame;
    return fits(frame) ? JSON.stringify(change(frame)) : text;
  };
}

/** Changes the messages of a topic. */
function topic(name: string, change: (text: string) => string) {
  return frames(
    (frame) => frame["topic"] === name,
    (frame) => JSON.parse(change(JSON.stringify(frame))) as object,
  );
}

function scaled(pattern: RegExp, factor: number) {
  return (text: string): string =>
    text.replaceAll(pattern, (_match, before: string, number: string) => {
      return before + String(Number(number) * factor);
    });
}

/** Changes velocities of a client; null drops them. */
function velocities(fits: (x: number) => boolean, change: ((text: string) => string) | null) {
  return (text: string): string | null => {
    const frame: unknown = JSON.parse(text);
    if (valueAt(frame, "topic") !== "/cmd_vel") return text;
    if (!fits(Number(valueAt(frame, "msg.linear.x") ?? 0))) return text;
    return change === null ? null : change(text);
  };
}

const always = (): boolean => true;

function answers(change: (answer: HttpMessage) => Partial<HttpMessage>, ofMethod = "POST") {
  return (answer: HttpMessage, method: string): HttpMessage =>
    method === ofMethod ? { ...answer, ...change(answer) } : answer;
}

function texts(before: string | RegExp, after: string, ofMethod?: string) {
  return answers(({ text }) => ({ text: text.replace(before, after) }), ofMethod);
}

let keys = 0;

export const gatewayFaults: readonly InjectedGatewayFault[] = [
  { caughtBy: "ros-key", fault: "the key in the header is not read", dropsKey: true },
  {
    caughtBy: "ros-key-wrong",
    fault: "a wrong key is refused after the upgrade",
    opensFirst: true,
  },
  {
    caughtBy: "ros-quiet",
    fault: "each client receives a status",
    greeting: '{"op":"status","level":"info","msg":"Welcome"}',
  },
  {
    caughtBy: "ros-topics",
    fault: "types are in another order",
    toClient: (text) => text.replace(/"types":\["([^"]*)","([^"]*)"/, '"types":["$2","$1"'),
  },
  {
    caughtBy: "ros-scan",
    fault: "the beams begin in front",
    toClient: topic("/scan", (text) =>
      text.replace(/"ranges":\[([^,]*),([^,]*),([^,]*),/, '"ranges":[$3,$2,$1,'),
    ),
  },
  {
    caughtBy: "ros-scan",
    fault: "distances are in cm",
    toClient: topic("/scan", (text) =>
      text.replace(/"ranges":\[([^\]]*)\]/, (_match, ranges: string) => {
        return `"ranges":[${ranges
          .split(",")
          .map((each) => String(Number(each) * 100))
          .join(",")}]`;
      }),
    ),
  },
  {
    caughtBy: "ros-odom",
    fault: "the position is in cm",
    toClient: topic("/odom", scaled(/("[xy]":)(-?[\d.e-]+)(?=,"[yz]":[^}]*},"orientation)/g, 100)),
  },
  {
    caughtBy: "ros-odom",
    fault: "yaw is clockwise",
    toClient: topic("/odom", scaled(/("z":)(-?[\d.e-]+)(?=,"w")/g, -1)),
  },
  {
    caughtBy: "ros-velocity",
    fault: "velocities are ignored",
    fromClient: velocities(always, null),
  },
  {
    caughtBy: "ros-velocity",
    fault: "velocities are powers of the wheels",
    fromClient: velocities(always, scaled(/("x":)([\d.]+)/g, 2.61)),
  },
  {
    caughtBy: "ros-velocity-zero",
    fault: "a velocity of zero is ignored",
    fromClient: velocities((x) => x === 0, null),
  },
  {
    caughtBy: "ros-velocity-turn",
    fault: "angular velocities are positive to the right",
    fromClient: velocities(always, scaled(/("z":)(-?[\d.]+)/g, -1)),
  },
  {
    caughtBy: "ros-reset",
    fault: "/reset answers without a reset",
    fromClient: (text) => text.replace('"/reset"', '"/stop"'),
    toClient: (text) => text.replace('"/stop"', '"/reset"'),
  },
  {
    caughtBy: "mcp-key",
    fault: "401 does not ask for a bearer key",
    response: answers(({ headers: { "www-authenticate": _challenge, ...headers } }) => ({
      headers,
    })),
  },
  {
    caughtBy: "mcp-post",
    fault: "GET opens an event stream",
    response: answers(() => ({ status: 200, text: "" }), "GET"),
  },
  {
    caughtBy: "mcp-tools",
    fault: "a tool has another name",
    response: texts('"name":"look"', '"name":"see"'),
  },
  {
    caughtBy: "mcp-sense",
    fault: "answers are texts only",
    response: texts('"structuredContent"', '"structured"'),
  },
  {
    caughtBy: "mcp-act",
    fault: "a repeated key moves the robot again",
    request: (text) => text.replace(/"key":"[^"]*"/, () => `"key":"another-key-${(keys += 1)}"`),
  },
  {
    caughtBy: "mcp-refusal",
    fault: "a refusal is an ordinary result",
    response: texts('"isError":true', '"isError":false'),
  },
  {
    caughtBy: "soap-wsdl",
    fault: "the address of the service is that of the process",
    response: texts(/location="[^"]*"/, 'location="http://0.0.0.0:1/soap"', "GET"),
  },
  {
    caughtBy: "soap-sense",
    fault: "front and back are swapped",
    response: answers(({ text }) => ({
      text: text.replaceAll(/(<\/?)(front|back)>/g, (_match, open: string, side: string) => {
        return `${open}${side === "front" ? "back" : "front"}>`;
      }),
    })),
  },
  {
    caughtBy: "soap-command",
    fault: "Command does not wait",
    request: (text) => text.replace(/<wait>\d+<\/wait>/, ""),
  },
  {
    caughtBy: "soap-fault",
    fault: "a fault has no typed detail",
    response: texts(/<detail>.*<\/detail>/s, ""),
  },
];
