import { SILENT_WORDS } from "@corridor/protocol";
import { chainOf, commentName, type CodeContent } from "./code-text.ts";

export function javascriptCode({ name, lines, address, command }: CodeContent): string {
  const rules = chainOf(lines, { indent: "  ", depth: 1, call: "await drive", hasBraces: true });
  return `// ${commentName(name)}
// Choose Remote on the robot's page. Then: ${command}
const ROBOT = ${address};

async function decide({ front, right, back, left }) {
${rules}
}

// The calls of the robot's service. The robot ends "forward" and "reverse" itself, as soon as one
// of the conditions at the end of the call is true: then another line decides.
import { randomUUID } from "node:crypto";

const [page, key] = ROBOT.split("#");
const api = page.replace("/r/", "/api/v1/robots/");
let now;

async function ask(path, order) {
  // With the key, a command that arrives twice runs once.
  const headers = { Authorization: \`Bearer \${key}\`, "Idempotency-Key": randomUUID() };
  headers["Content-Type"] = "application/json";
  const request = { method: order ? "POST" : "GET", headers, body: JSON.stringify(order) };
  for (let attempt = 0; attempt < 40; attempt++) {
    const signal = AbortSignal.timeout(35_000);
    const answer = await fetch(api + path, { ...request, signal }).catch(() => null); // connection lost
    const data = await answer?.json().catch(() => null);
    if (data && answer.ok) return data;
    if (data && answer.status !== 429 && answer.status < 500) throw new Error(data.detail);
    await new Promise((resolve) => setTimeout(resolve, 1000 * Math.random()));
  }
  throw new Error("The robot's service does not answer.");
}

async function run(order) {
  let record = await ask("/commands", order);
  while (["accepted", "delivered", "started"].includes(record.state)) {
    record = await ask(\`/commands/\${record.seq}?wait=25\`);
  }
  return record;
}

async function drive(line, action, until = "") {
  console.log(\`\${line}: \${action}\`);
  if (action === "stop") throw new Error(\`\${line} stops the robot. No reading changes after that.\`);
  const order = { action, ttl: 60_000 };
  if (action === "forward" || action === "reverse") {
    order.until = [{ goal: true }];
    for (const text of until ? until.split(" or ") : []) {
      const [sensor, is, than, ...plus] = text.split(" ");
      if (plus.length > 0) order.until.push({ sensor, is, than, plus: Number(plus.join("")) });
      else order.until.push({ sensor, is, than: Number(than) });
    }
  }
  const { state, reason, pose } = await run(order);
  if (state === "collided" && JSON.stringify(pose) === JSON.stringify(now.pose))
    throw new Error(\`\${line} drives against a wall. No reading changes after that.\`);
  // After a lost connection, the robot stands on its path: decide again.
  if (state !== "completed" && state !== "collided" && !reason?.includes("${SILENT_WORDS}"))
    throw new Error(reason ?? state);
}

process.on("uncaughtException", ({ message }) => console.error(message) ?? process.exit(1));
// A robot that cannot go back to its start drives from where it is.
await run({ action: "reset" }).catch(() => undefined);
while (!(now = await ask("/sensors?wait=10")).goalReached) await decide(now.sensors);
console.log("The robot has reached the goal.");
`;
}
