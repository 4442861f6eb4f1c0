/**
 * Scripts to copy: short, complete, without anything to install. Python and JavaScript follow the
 * right wall in steps of one block until the goal.
 */

export const snippetLanguages = ["python", "javascript", "curl"] as const;
export type SnippetLanguage = (typeof snippetLanguages)[number];

/**
 * @param api where the robot's REST calls begin, without a slash at the end
 * @param key the driver key, or a mask where it is only shown
 */
export function snippet(language: SnippetLanguage, api: string, key: string): string {
  const texts = { python, javascript, curl };
  return texts[language](api, key);
}

function python(api: string, key: string): string {
  return `import json
from urllib.request import Request, urlopen

ROBOT = "${api}"
KEY = "${key}"

def ask(path, command=None):
    body = None if command is None else json.dumps(command).encode()
    headers = {"Authorization": "Bearer " + KEY, "Content-Type": "application/json"}
    with urlopen(Request(ROBOT + path, body, headers)) as answer:
        return json.load(answer)

def do(action, **numbers):
    command = ask("/commands", {"action": action, **numbers})
    while command["state"] in ("accepted", "delivered", "started"):
        command = ask(f"/commands/{command['seq']}?wait=20")

while not ask("/sensors")["goalReached"]:
    sensors = ask("/sensors")["sensors"]
    if sensors["right"] > 60:
        do("right 90")
    elif sensors["front"] < 60:
        do("left 90")
        continue
    do("move", distance=100)
print("Goal reached")
`;
}

function javascript(api: string, key: string): string {
  return `const robot = "${api}";
const headers = { Authorization: "Bearer ${key}", "Content-Type": "application/json" };

async function ask(path, command) {
  const request = command ? { method: "POST", body: JSON.stringify(command) } : {};
  const answer = await fetch(robot + path, { headers, ...request });
  if (!answer.ok) throw new Error(await answer.text());
  return answer.json();
}

async function act(action, numbers) {
  let command = await ask("/commands", { action, ...numbers });
  while (["accepted", "delivered", "started"].includes(command.state)) {
    command = await ask(\`/commands/\${command.seq}?wait=20\`);
  }
}

while (!(await ask("/sensors")).goalReached) {
  const { sensors } = await ask("/sensors");
  if (sensors.right > 60) {
    await act("right 90");
  } else if (sensors.front < 60) {
    await act("left 90");
    continue;
  }
  await act("move", { distance: 100 });
}
console.log("Goal reached");
`;
}

function curl(api: string, key: string): string {
  return `curl -s ${api}/sensors \\
  -H "Authorization: Bearer ${key}"

curl -s ${api}/commands \\
  -H "Authorization: Bearer ${key}" \\
  -H "Content-Type: application/json" \\
  -d '{"action":"left 90"}'
`;
}
