// Follow the right-hand wall through a maze.
//
// Run it with the robot's address, which the page shows under Remote. Keep the quotes. If you cannot
// copy the address, use a pairing code: see the README of the examples.
//
//     dotnet run Robot.cs "http://localhost:8080/r/ID#KEY"
//
// Requires .NET 10 or newer and no packages. With .NET Core 3.1 or newer, create a project with
// `dotnet new console` and replace its Program.cs with this file. The robot follows the wall on its
// right: it turns right at an opening, else drives straight ahead, else turns left.
#nullable enable
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Net.Http;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Threading.Tasks;

/// <summary>The robot or the service rejected a request, or did not answer.</summary>
class RobotException : Exception
{
    public RobotException(string message) : base(message) { }
}

/// <summary>Sensor readings and position of the robot in cm.</summary>
class Snapshot
{
    public double Front, Right, X, Y;
    public bool GoalReached;
}

/// <summary>A robot on the network. Every method waits until the robot has finished.</summary>
class Robot
{
    // The name of this program on the robot's page.
    private const string Name = "Right wall";
    // Time without an answer after which the program gives up.
    private static readonly TimeSpan Timeout = TimeSpan.FromSeconds(30);
    private const double FirstDelayMs = 250;
    private const double MaxDelayMs = 10_000;

    // No redirects, so that the key is not sent to another host. Uses the proxy of the system.
    private readonly HttpClient http =
        new HttpClient(new HttpClientHandler { AllowAutoRedirect = false }) { Timeout = TimeSpan.FromSeconds(20) };
    private readonly Random random = new Random();
    private readonly string api;
    private readonly string key;

    public Robot(string address)
    {
        var parts = Regex.Match(
            address.Trim(),
            @"^(https?://[^/?#\s@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})$");
        if (!parts.Success)
        {
            throw new RobotException(
                "This is not a robot's address. Copy the whole address from the page, and put it in "
                + "\"quotes\": the part after the # is the key.");
        }
        api = $"{parts.Groups[1].Value}/api/v1/robots/{parts.Groups[2].Value}";
        key = parts.Groups[3].Value;
    }

    /// <summary>Drives a distance in cm. Returns "completed", or "collided" if a wall stopped the robot.</summary>
    public Task<string> Forward(double distance) =>
        Command($"\"action\":\"move\",\"distance\":{distance.ToString(CultureInfo.InvariantCulture)}");

    public Task<string> Left() => Command("\"action\":\"left 90\"");

    public Task<string> Right() => Command("\"action\":\"right 90\"");

    /// <summary>Returns the current snapshot, never older than the end of the last command.</summary>
    public async Task<Snapshot> GetSnapshot()
    {
        var json = await Send(HttpMethod.Get, "/sensors?wait=10");
        var sensors = json.GetProperty("sensors");
        var pose = json.GetProperty("pose");
        return new Snapshot
        {
            Front = sensors.GetProperty("front").GetDouble(),
            Right = sensors.GetProperty("right").GetDouble(),
            X = pose.GetProperty("x").GetDouble(),
            Y = pose.GetProperty("y").GetDouble(),
            GoalReached = json.GetProperty("goalReached").GetBoolean(),
        };
    }

    // Sends a command, waits until it has ended, and returns its state.
    private async Task<string> Command(string fields)
    {
        var record = await Send(HttpMethod.Post, "/commands", fields);
        while (true)
        {
            var state = record.GetProperty("state").GetString() ?? "";
            switch (state)
            {
                case "completed":
                case "collided":
                    return state;
                case "cancelled":
                case "superseded":
                case "expired":
                    var action = record.GetProperty("action");
                    throw new RobotException($"{action} was {state}: {record.GetProperty("reason")}");
            }
            record = await Send(HttpMethod.Get, $"/commands/{record.GetProperty("seq")}?wait=10");
        }
    }

    // Sends a request to the service. Retries after network errors and server errors.
    private async Task<JsonElement> Send(HttpMethod method, string path, string? fields = null)
    {
        // The key makes a retry safe: a command that arrives twice runs once.
        var idempotencyKey = Guid.NewGuid().ToString();
        var clock = Stopwatch.StartNew();
        for (var attempt = 0; ; attempt++)
        {
            string message;
            try
            {
                using var request = CreateRequest(method, path, fields, idempotencyKey, clock.ElapsedMilliseconds);
                using var response = await http.SendAsync(request);
                var text = await response.Content.ReadAsStringAsync();
                var status = (int)response.StatusCode;
                if (response.IsSuccessStatusCode) return Parse(text);
                message = ErrorMessage(status, text);
                if (status != 429 && status < 500) throw new RobotException(message);
            }
            catch (Exception error) when (
                error is HttpRequestException || error is IOException || error is TaskCanceledException)
            {
                message = $"The service does not respond: {error.Message}";
            }
            // A random delay, so that the programs of a whole class do not retry at the same moment.
            var limit = Math.Min(MaxDelayMs, FirstDelayMs * Math.Pow(2, attempt));
            var delay = TimeSpan.FromMilliseconds(random.NextDouble() * limit);
            if (clock.Elapsed + delay > Timeout) throw new RobotException(message);
            await Task.Delay(delay);
        }
    }

    private HttpRequestMessage CreateRequest(HttpMethod method, string path, string? fields, string idempotencyKey, long age)
    {
        var request = new HttpRequestMessage(method, api + path);
        request.Headers.Add("Authorization", $"Bearer {key}");
        request.Headers.Add("Script-Name", Name);
        request.Headers.Add("User-Agent", ".NET-example");
        if (fields == null) return request;
        // With the age in ms, the robot rejects a retry that arrives too late.
        var body = age == 0 ? $"{{{fields}}}" : $"{{{fields},\"age\":{age}}}";
        request.Headers.Add("Idempotency-Key", idempotencyKey);
        request.Content = new StringContent(body, Encoding.UTF8, "application/json");
        return request;
    }

    private static JsonElement Parse(string text)
    {
        try
        {
            return JsonDocument.Parse(text).RootElement;
        }
        catch (JsonException)
        {
            throw new RobotException("The server at this address is not a robot's host.");
        }
    }

    // Returns the error message of the service.
    private static string ErrorMessage(int status, string text)
    {
        try
        {
            var detail = JsonDocument.Parse(text).RootElement.GetProperty("detail").GetString();
            if (detail != null) return detail;
        }
        catch (Exception error) when (
            error is JsonException || error is InvalidOperationException || error is KeyNotFoundException)
        {
            // The response is from another server, such as a proxy.
        }
        return $"The service answered with status {status}.";
    }
}

static class Program
{
    // One cell of the maze is 100 cm wide.
    private const int Cell = 100;
    // A larger distance in cm means that the next cell is open.
    private const int Open = 60;

    static async Task<int> Main(string[] args)
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        try
        {
            var robot = new Robot(args.Length == 0 ? "" : args[0]);
            await FollowRightWall(robot, Option(args, "--until-cells", 0), Option(args, "--moves", 2000));
            return 0;
        }
        catch (Exception error) when (error is RobotException || error is FormatException)
        {
            Console.Error.WriteLine(error.Message);
            return 1;
        }
    }

    // Returns the value of an option: the argument after its name.
    static int Option(string[] args, string name, int fallback)
    {
        var at = Array.IndexOf(args, name);
        return at < 0 || at + 1 >= args.Length ? fallback : int.Parse(args[at + 1]);
    }

    // Drives until the goal is reached, or until untilCells different cells are visited.
    static async Task FollowRightWall(Robot robot, int untilCells, int maxMoves)
    {
        var visited = new HashSet<(int, int)>();
        var moves = 0;
        while (true)
        {
            var snapshot = await robot.GetSnapshot();
            visited.Add(((int)(snapshot.X / Cell), (int)(snapshot.Y / Cell)));
            if (untilCells == 0 && snapshot.GoalReached)
            {
                Console.WriteLine($"Goal reached after {moves} moves.");
                return;
            }
            if (untilCells > 0 && visited.Count >= untilCells)
            {
                Console.WriteLine($"{visited.Count} cells visited after {moves} moves.");
                return;
            }
            if (moves >= maxMoves)
            {
                throw new RobotException($"Goal not reached after {moves} moves; {visited.Count} cells visited.");
            }
            string state;
            if (snapshot.Right > Open)
            {
                Console.WriteLine($"{snapshot.Right:F0} cm on the right: turn right and drive");
                await robot.Right();
                state = await robot.Forward(Cell);
                moves++;
            }
            else if (snapshot.Front > Open)
            {
                Console.WriteLine($"{snapshot.Front:F0} cm ahead: drive on");
                state = await robot.Forward(Cell);
                moves++;
            }
            else
            {
                Console.WriteLine("Wall ahead and on the right: turn left");
                state = await robot.Left();
            }
            if (state == "collided") Console.WriteLine("Bumped into a wall!");
        }
    }
}
