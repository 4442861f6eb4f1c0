/**
 * Scripts for the robot's own API. The first uses the library for Python. The others need no
 * installation: they send one command, print its final state or why the robot rejected it, and exit
 * with 0 only if it is completed.
 */
import { addressOf, apiOf, type RobotParts } from "./robot-parts.ts";

export function python(robot: RobotParts): string {
  return `from corridor import Robot
robot = Robot("${addressOf(robot)}")
while robot.sensor.front > 60:
    robot.forward(100)
robot.left(90)
print(round(robot.sensor.front))
`;
}

export function plainPython(robot: RobotParts): string {
  return `import json
from urllib import error, request
robot = "${apiOf(robot)}"
headers = {"Authorization": "Bearer ${robot.key}", "Content-Type": "application/json"}
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

export function javascript(robot: RobotParts): string {
  return `const robot = "${apiOf(robot)}";
const headers = { Authorization: "Bearer ${robot.key}", "Content-Type": "application/json" };
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

export function java(robot: RobotParts): string {
  return `import java.net.http.*;
public class Robot {
  static String ask(String path, String... body) throws Exception {
    var request = HttpRequest.newBuilder(java.net.URI.create("${apiOf(robot)}" + path))
        .headers("Authorization", "Bearer ${robot.key}", "Content-Type", "application/json");
    if (body.length > 0) request.POST(HttpRequest.BodyPublishers.ofString(body[0]));
    return HttpClient.newHttpClient().send(request.build(), HttpResponse.BodyHandlers.ofString()).body(); }
  public static void main(String[] words) throws Exception {
    var text = ask("/commands", "{\\"action\\":\\"left 90\\"}");
    if (text.contains("\\"seq\\":")) text = ask("/commands/" + text.replaceAll(".*\\"seq\\": *(\\\\d+).*", "$1") + "?wait=25");
    System.out.println(text.replaceAll(".*\\"(?:detail|reason)\\": *\\"([^\\"]+)\\".*|.*\\"state\\": *\\"(\\\\w+)\\".*", "$1$2"));
    System.exit(text.matches(".*\\"state\\": *\\"completed\\".*") ? 0 : 1); } }
`;
}

export function csharp(robot: RobotParts): string {
  return `using System;
using System.Net.Http;
using System.Text;
using System.Text.RegularExpressions;
class Robot {
    static readonly HttpClient http = new HttpClient();
    static string Ask(string path, string body = null) {
        var method = body == null ? HttpMethod.Get : HttpMethod.Post;
        var request = new HttpRequestMessage(method, "${apiOf(robot)}" + path);
        request.Headers.Add("Authorization", "Bearer ${robot.key}");
        request.Headers.Add("User-Agent", ".NET");
        if (body != null) request.Content = new StringContent(body, Encoding.UTF8, "application/json");
        return http.SendAsync(request).Result.Content.ReadAsStringAsync().Result;
    }
    static string Field(string json, string name) =>
        Regex.Match(json, "\\"" + name + "\\": *\\"?((?<=\\")[^\\"]*|\\\\d+)").Groups[1].Value;
    static int Main() {
        var command = Ask("/commands", "{\\"action\\":\\"left 90\\"}");
        var seq = Field(command, "seq");
        if (seq != "") command = Ask("/commands/" + seq + "?wait=25");
        string state = Field(command, "state"), why = Field(command, "detail") + Field(command, "reason");
        Console.WriteLine(why == "" ? state : why);
        return state == "completed" ? 0 : 1;
    }
}
`;
}

export function go(robot: RobotParts): string {
  return `package main

import ("cmp"; "encoding/json"; "fmt"; "net/http"; "os"; "strings")

func ask(method, path, body string) (record map[string]any) {
	request, _ := http.NewRequest(method, "${apiOf(robot)}"+path, strings.NewReader(body))
	request.Header = http.Header{"Authorization": {"Bearer ${robot.key}"}, "Content-Type": {"application/json"}}
	answer, err := http.DefaultClient.Do(request)
	if err != nil {
		panic(err)
	}
	json.NewDecoder(answer.Body).Decode(&record)
	return record
}

func main() {
	command := ask("POST", "/commands", \`{"action":"left 90"}\`)
	if seq, ok := command["seq"].(float64); ok {
		command = ask("GET", fmt.Sprintf("/commands/%.0f?wait=25", seq), "")
	}
	fmt.Println(cmp.Or(command["detail"], command["reason"], command["state"]))
	if command["state"] != "completed" {
		os.Exit(1)
	}
}
`;
}

export function curl(robot: RobotParts): string {
  return `ROBOT="${apiOf(robot)}"
AUTH="Authorization: Bearer ${robot.key}"
JSON="Content-Type: application/json"
ANSWER=$(curl -sS $ROBOT/commands -H "$AUTH" -H "$JSON" -d '{"action":"left 90"}')
SEQ=$(echo "$ANSWER" | grep -o '"seq": *[0-9]*' | tr -dc 0-9)
if [ "$SEQ" ]; then ANSWER=$(curl -sS "$ROBOT/commands/$SEQ?wait=25" -H "$AUTH"); fi
echo "$ANSWER" | grep -oE '"(state|reason|detail)": *"[^"]*"'
echo "$ANSWER" | grep -q '"state": *"completed"' || exit 1
`;
}
