/**
 * Scripts to copy. The starter script uses the library, `corridor.py`. The others need nothing to be installed;
 * Python, JavaScript and Java follow the right wall in steps of one block until the goal.
 */

/** Lines of the starter script. */
export const starterLines = 6;

/** @param address the robot's address with its key, or with a mask where it is only displayed */
export function starterScript(address: string): string {
  return `from corridor import Robot
robot = Robot("${address}")
while robot.sensor.front > 60:
    robot.forward(100)
robot.left(90)
print(robot.sensor.front)
`;
}

export const snippetLanguages = ["javascript", "java", "curl", "python"] as const;
export type SnippetLanguage = (typeof snippetLanguages)[number];

/**
 * @param api where the robot's REST calls begin, without a slash at the end
 * @param key the driver key, or a mask where it is only shown
 */
export function snippet(language: SnippetLanguage, api: string, key: string): string {
  const texts = { python, javascript, java, curl };
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

function java(api: string, key: string): string {
  return `import java.net.URI;
import java.net.http.*;
import java.util.regex.Pattern;

public class Robot {
  static final String ROBOT = "${api}";
  static final String KEY = "${key}";
  static final HttpClient WEB = HttpClient.newHttpClient();

  static String ask(String path, String... command) throws Exception {
    var request = HttpRequest.newBuilder(URI.create(ROBOT + path))
        .headers("Authorization", "Bearer " + KEY, "Content-Type", "application/json");
    for (var body : command) request.POST(HttpRequest.BodyPublishers.ofString(body));
    var answer = WEB.send(request.build(), HttpResponse.BodyHandlers.ofString());
    if (answer.statusCode() >= 400) throw new Exception(answer.body());
    return answer.body();
  }

  static String find(String name, String text) {
    var found = Pattern.compile('"' + name + "\\":\\"?([\\\\w.]+)").matcher(text);
    return found.find() ? found.group(1) : "";
  }

  static void act(String command) throws Exception {
    var told = ask("/commands", command.replace('\\'', '"'));
    while (find("state", told).matches("accepted|delivered|started"))
      told = ask("/commands/" + find("seq", told) + "?wait=20");
  }

  public static void main(String[] args) throws Exception {
    while (!find("goalReached", ask("/sensors")).equals("true")) {
      var sensors = ask("/sensors");
      if (Double.parseDouble(find("right", sensors)) > 60) {
        act("{'action':'right 90'}");
      } else if (Double.parseDouble(find("front", sensors)) < 60) {
        act("{'action':'left 90'}");
        continue;
      }
      act("{'action':'move','distance':100}");
    }
    System.out.println("Goal reached");
  }
}
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
