import { SILENT_WORDS } from "@corridor/protocol";
import { chainOf, commentName, type CodeContent } from "./code-text.ts";

export function csharpCode({ name, lines, address, command }: CodeContent): string {
  const rules = chainOf(lines, { indent: "    ", depth: 2, call: "Drive", hasBraces: true });
  return `// ${commentName(name)}
// Choose Remote on the robot's page. Then: ${command}
using System;
using System.Globalization;
using System.Linq;
using System.Net.Http;
using System.Text;
using System.Text.RegularExpressions;
using System.Threading;

class Rules {
    const string Robot = ${address};

    static void Decide(double front, double right, double back, double left) {
${rules}
    }

    // The calls of the robot's service. The robot ends "forward" and "reverse" itself, as soon as
    // one of the conditions at the end of the call is true: then another line decides.
    static readonly HttpClient http = new HttpClient { Timeout = TimeSpan.FromSeconds(35) };
    static readonly Random random = new Random();
    static string now;
    static string Ask(string path, string order = null) {
        var parts = Robot.Replace("/r/", "/api/v1/robots/").Split('#');
        var key = Guid.NewGuid().ToString(); // With the key, a command that arrives twice runs once.
        for (var attempt = 0; attempt < 40; attempt++) {
            try {
                var request = new HttpRequestMessage(order == null ? HttpMethod.Get : HttpMethod.Post, parts[0] + path);
                request.Headers.Add("Authorization", "Bearer " + parts[1]);
                request.Headers.Add("Idempotency-Key", key);
                if (order != null) request.Content = new StringContent("{" + order + "}", Encoding.UTF8, "application/json");
                var answer = http.SendAsync(request).GetAwaiter().GetResult();
                var text = answer.Content.ReadAsStringAsync().GetAwaiter().GetResult();
                var status = (int)answer.StatusCode;
                if (status < 300) return text;
                if (status != 429 && status < 500) throw new ApplicationException(Field(text, "detail"));
            } catch (Exception error) when (!(error is ApplicationException)) { } // a lost connection
            Thread.Sleep(random.Next(1000));
        }
        throw new ApplicationException("The robot's service does not answer.");
    }
    static string Run(string order) {
        var record = Ask("/commands", order);
        while (Regex.IsMatch(Field(record, "state"), "accepted|delivered|started"))
            record = Ask("/commands/" + Field(record, "seq") + "?wait=25");
        return record;
    }
    static void Drive(string line, string action, params string[] until) {
        Console.WriteLine(line + ": " + action);
        if (action == "stop") throw new ApplicationException(line + " stops the robot. No reading changes after that.");
        string order = "\\"action\\":\\"" + action + "\\",\\"ttl\\":60000", ends = "{\\"goal\\":true}";
        foreach (var text in Regex.Split(string.Concat(until), " or ").Where(each => each != ""))
            ends += ",{" + Regex.Replace(
                Regex.Replace(text, @"(\\w+) (\\S+) (.+)", "\\"sensor\\":\\"$1\\",\\"is\\":\\"$2\\",\\"than\\":$3}"),
                @"right [+]?(-?) (.+)}", "\\"right\\",\\"plus\\":$1$2}");
        if (action == "forward" || action == "reverse") order += ",\\"until\\":[" + ends + "]";
        string record = Run(order), state = Field(record, "state"), reason = Field(record, "reason");
        if (state == "collided" && Field(record, "pose") == Field(now, "pose"))
            throw new ApplicationException(line + " drives against a wall. No reading changes after that.");
        // After a lost connection, the robot stands on its path: decide again.
        if (state != "completed" && state != "collided" && !reason.Contains("${SILENT_WORDS}"))
            throw new ApplicationException(reason == "null" ? state : reason);
    }
    static string Field(string json, string name) => Regex.Replace(Regex.Match(json,
        "\\"" + name + "\\":\\\\s*(\\\\{[^}]*|\\"(\\\\\\\\.|[^\\"\\\\\\\\])*|[^,}]*)").Groups[1].Value, "^\\"|\\\\\\\\(?=\\")", "");
    static double Number(string name) => double.Parse(Field(now, name), CultureInfo.InvariantCulture);
    static void Main() {
        // A robot that cannot go back to its start drives from where it is.
        try { Run("\\"action\\":\\"reset\\""); } catch (ApplicationException) { }
        try {
            while (Field(now = Ask("/sensors?wait=10"), "goalReached") != "true")
                Decide(Number("front"), Number("right"), Number("back"), Number("left"));
            Console.WriteLine("The robot has reached the goal.");
        } catch (ApplicationException end) { Console.Error.WriteLine(end.Message); Environment.Exit(1); }
    }
}
`;
}
