import { SILENT_WORDS } from "@corridor/protocol";
import { chainOf, commentName, type CodeContent } from "./code-text.ts";

export function pythonCode({ name, lines, address, command }: CodeContent): string {
  const rules = chainOf(lines, { indent: "    ", depth: 1, call: "drive", hasBraces: false });
  return `# ${commentName(name)}
# Choose Remote on the robot's page. Then: ${command}
ROBOT = ${address}

def decide(front, right, back, left):
${rules}


# The calls of the robot's service. The robot ends "forward" and "reverse" itself, as soon as one
# of the conditions at the end of the call is true: then another line decides.
import http.client, json, random, signal, sys, time, urllib.error, urllib.request, uuid

page, key = ROBOT.split("#")
api = page.replace("/r/", "/api/v1/robots/")
signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl+C

def ask(path, order=None):
    # With the key, a command that arrives twice runs once.
    headers = {"Authorization": "Bearer " + key, "Idempotency-Key": uuid.uuid4().hex,
               "Content-Type": "application/json"}
    body = json.dumps(order).encode() if order else None
    request = urllib.request.Request(api + path, body, headers)
    for _ in range(40):
        try:
            with urllib.request.urlopen(request, timeout=35) as answer:
                return json.load(answer)
        except urllib.error.HTTPError as refused:
            if refused.code != 429 and refused.code < 500:
                sys.exit(json.load(refused)["detail"])
        except (OSError, http.client.HTTPException, ValueError):
            pass  # a lost connection
        time.sleep(random.random())
    sys.exit("The robot's service does not answer.")

def run(order):
    record = ask("/commands", order)
    while record["state"] in ("accepted", "delivered", "started"):
        record = ask(f"/commands/{record['seq']}?wait=25")
    return record

def drive(line, action, until=""):
    print(f"{line}: {action}", flush=True)
    if action == "stop":
        sys.exit(f"{line} stops the robot. No reading changes after that.")
    order = {"action": action, "ttl": 60000}
    if action in ("forward", "reverse"):
        order["until"] = [{"goal": True}]
        for sensor, comparison, than, *plus in map(str.split, until.split(" or ") if until else []):
            number = {"than": than, "plus": float("".join(plus))} if plus else {"than": float(than)}
            order["until"].append({"sensor": sensor, "is": comparison, **number})
    record = run(order)
    if record["state"] == "collided" and record["pose"] == pose:
        sys.exit(f"{line} drives against a wall. No reading changes after that.")
    # After a lost connection, the robot stands on its path: decide again.
    if record["state"] not in ("completed", "collided") and "${SILENT_WORDS}" not in str(record["reason"]):
        sys.exit(record["reason"] or record["state"])

try:
    run({"action": "reset"})
except SystemExit:
    pass  # A robot that cannot go back to its start drives from where it is.
snapshot = ask("/sensors?wait=10")
while not snapshot["goalReached"]:
    pose = snapshot["pose"]
    decide(**snapshot["sensors"])
    snapshot = ask("/sensors?wait=10")
print("The robot has reached the goal.")
`;
}
