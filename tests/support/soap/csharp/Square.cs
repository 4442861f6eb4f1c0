using System;
using System.Net;
using System.Web.Services.Protocols;

namespace Robots {
    /// The generated class, with the key of a robot in the header.
    partial class CorridorRobot {
        public string Key;

        protected override WebRequest GetWebRequest(Uri url) {
            var request = base.GetWebRequest(url);
            if (Key != null) request.Headers["Authorization"] = "Bearer " + Key;
            return request;
        }
    }
}

/// A client that Mono's wsdl generates from the running service. It drives one robot with its key in
/// the address, and another with its key in a header. Prints a line for each result.
static class Square {
    static readonly Robots.CorridorRobot service = new Robots.CorridorRobot();

    static void Main(string[] addresses) {
        var robot = addresses[0];
        Robots.SensorReadings sensors;
        Sense(robot, out sensors);
        Console.WriteLine("front " + sensors.front);
        Drive(robot, "square-1");
        var near = new Robots.UntilCondition {
            sensor = Robots.Sensor.front, sensorSpecified = true, @is = "<=", than = "60",
        };
        Console.WriteLine("until " + Send(robot, Robots.Action.forward, null, null, near));
        Console.WriteLine("log " + service.GetCommands(robot, 0, false).Length);
        try {
            Send(robot, Robots.Action.move, 90000, null);
        } catch (SoapException fault) {
            var detail = fault.Detail["RobotFault"];
            Console.WriteLine("fault " + detail["code"].InnerText + " " + detail["errors"]["path"].InnerText);
            Console.WriteLine(fault.Message);
        }

        var other = addresses[1].Split('#');
        service.Key = other[1];
        Drive(other[0], "square-2");
        Console.WriteLine("heading " + Sense(other[0], out sensors).heading);
    }

    /// Drives forward and turns right, four times.
    static void Drive(string robot, string key) {
        for (var side = 0; side < 4; side++) {
            Console.WriteLine("move " + Send(robot, Robots.Action.move, 100, key + "-move-" + side));
            Console.WriteLine("right 90 " + Send(robot, Robots.Action.right90, null, key + "-turn-" + side));
        }
    }

    static Robots.Pose Sense(string robot, out Robots.SensorReadings sensors) {
        Robots.Pose pose;
        string motion, line;
        long bumps, seq, command;
        bool isBumping, isAtGoal, hasCommand;
        Robots.RobotState state;
        Robots.Driver driver;
        service.Sense(robot, 0, false, 0, false, out sensors, out pose, out motion, out bumps, out isBumping,
            out isAtGoal, out seq, out state, out driver, out line, out command, out hasCommand);
        return pose;
    }

    static Robots.CommandState Send(
        string robot, Robots.Action action, double? cm, string key, params Robots.UntilCondition[] until) {
        var distance = cm ?? 0;
        var hasDistance = cm != null;
        string sent, reason;
        Robots.RecordedCommand command;
        Robots.CommandState state;
        DateTime acceptedAt;
        Robots.Pose pose;
        bool isDuplicate;
        service.Command(robot, action, ref distance, ref hasDistance, 0, false, 0, false, false, false, 0, false,
            0, false, 0, false, 0, false, until, 0, false, ref key, 25, true, out sent, out command, out state,
            out reason, out acceptedAt, out pose, out isDuplicate);
        return state;
    }
}
