/**
 * Scripts to copy. The starter script uses the library, `corridor.py`. The others need no
 * installation: they send one command, print its final state or why the robot rejected it, and exit
 * with 0 only if it is completed.
 */

/** Number of lines of the starter script. */
export const starterLines = 6;

/** @param address the robot's address with its key, or with a masked key to display */
export function starterScript(address: string): string {
  return `from corridor import Robot
robot = Robot("${address}")
while robot.sensor.front > 60:
    robot.forward(100)
robot.left(90)
print(round(robot.sensor.front))
`;
}

export const snippetLanguages = ["javascript", "java", "curl", "python"] as const;
export type SnippetLanguage = (typeof snippetLanguages)[number];

/** How to save and start a script, as in the quickstart of /docs. */
export const snippetFiles: Record<
  SnippetLanguage,
  { file: string; command: string; program: string | null }
> = {
  javascript: { file: "drive.mjs", command: "node drive.mjs", program: "Node 18" },
  java: { file: "Robot.java", command: "java Robot.java", program: "Java 11" },
  curl: { file: "drive.sh", command: "sh drive.sh", program: null },
  python: { file: "drive.py", command: "python3 drive.py", program: null },
};

/**
 * @param api base URL of the robot's REST API, without a trailing slash
 * @param key the driver key, or a mask to display
 */
export function snippet(language: SnippetLanguage, api: string, key: string): string {
  const texts = { python, javascript, java, curl };
  return texts[language](api, key);
}

function python(api: string, key: string): string {
  return `import json
from urllib import error, request
robot = "${api}"
headers = {"Authorization": "Bearer ${key}", "Content-Type": "application/json"}
def ask(path, body=None):
    return json.load(request.urlopen(request.Request(robot + path, body, headers)))
try:
    command = ask("/commands", b'{"action": "left 90"}')
    command = ask(f"/commands/{command['seq']}?wait=25")
    print(command["state"])
    raise SystemExit(command["reason"])
except error.HTTPError as refused:
    raise SystemExit(json.load(refused)["detail"])
`;
}

function javascript(api: string, key: string): string {
  return `const robot = "${api}";
const headers = { Authorization: "Bearer ${key}", "Content-Type": "application/json" };
async function ask(path, body) {
  const method = body ? "POST" : "GET";
  const answer = await fetch(robot + path, { method, headers, body: JSON.stringify(body) });
  return answer.json();
}
let command = await ask("/commands", { action: "left 90" });
if (command.seq) command = await ask(\`/commands/\${command.seq}?wait=25\`);
console.log(command.detail ?? command.reason ?? command.state);
process.exitCode = command.state === "completed" ? 0 : 1;
`;
}

function java(api: string, key: string): string {
  return `import java.net.http.*;
public class Robot {
  static String ask(String path, String... body) throws Exception {
    var request = HttpRequest.newBuilder(java.net.URI.create("${api}" + path))
        .headers("Authorization", "Bearer ${key}", "Content-Type", "application/json");
    if (body.length > 0) request.POST(HttpRequest.BodyPublishers.ofString(body[0]));
    return HttpClient.newHttpClient().send(request.build(), HttpResponse.BodyHandlers.ofString()).body(); }
  public static void main(String[] words) throws Exception {
    var text = ask("/commands", "{\\"action\\":\\"left 90\\"}");
    if (text.contains("\\"seq\\":")) text = ask("/commands/" + text.replaceAll(".*\\"seq\\":(\\\\d+).*", "$1") + "?wait=25");
    System.out.println(text.replaceAll(".*\\"(?:detail|reason)\\":\\"([^\\"]+)\\".*|.*\\"state\\":\\"(\\\\w+)\\".*", "$1$2"));
    System.exit(text.contains("\\"state\\":\\"completed\\"") ? 0 : 1); } }
`;
}

function curl(api: string, key: string): string {
  return `ROBOT="${api}"
AUTH="Authorization: Bearer ${key}"
JSON="Content-Type: application/json"
ANSWER=$(curl -sS $ROBOT/commands -H "$AUTH" -H "$JSON" -d '{"action":"left 90"}')
SEQ=$(echo "$ANSWER" | grep -o '"seq":[0-9]*' | cut -d: -f2)
if [ "$SEQ" ]; then ANSWER=$(curl -sS "$ROBOT/commands/$SEQ?wait=25" -H "$AUTH"); fi
echo "$ANSWER" | grep -oE '"(state|reason|detail)":"[^"]*"'
echo "$ANSWER" | grep -q '"state":"completed"' || exit 1
`;
}
