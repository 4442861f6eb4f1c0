/**
 * Definitions of the ROS messages, services and actions that Corridor uses, in the text format of
 * ROS: one field a line, parts of services and actions separated by `---`. Field names and types are
 * those of ROS 2 Jazzy; `corridor_msgs` is Corridor's own.
 */

/** By short name, without `/msg/`. */
export const messageTexts = {
  "builtin_interfaces/Time": "int32 sec\nuint32 nanosec",
  "geometry_msgs/Point": "float64 x\nfloat64 y\nfloat64 z",
  "geometry_msgs/Pose": "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation",
  "geometry_msgs/Pose2D": "float64 x\nfloat64 y\nfloat64 theta",
  "geometry_msgs/PoseWithCovariance": "geometry_msgs/Pose pose\nfloat64[36] covariance",
  "geometry_msgs/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w",
  "geometry_msgs/Transform": "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation",
  "geometry_msgs/TransformStamped":
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform",
  "geometry_msgs/Twist": "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular",
  "geometry_msgs/TwistStamped": "std_msgs/Header header\ngeometry_msgs/Twist twist",
  "geometry_msgs/TwistWithCovariance": "geometry_msgs/Twist twist\nfloat64[36] covariance",
  "geometry_msgs/Vector3": "float64 x\nfloat64 y\nfloat64 z",
  "nav_msgs/MapMetaData":
    "builtin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\ngeometry_msgs/Pose origin",
  "nav_msgs/OccupancyGrid": "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data",
  "nav_msgs/Odometry":
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\ngeometry_msgs/TwistWithCovariance twist",
  "rcl_interfaces/Log":
    "byte DEBUG=10\nbyte INFO=20\nbyte WARN=30\nbyte ERROR=40\nbyte FATAL=50\nbuiltin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\nstring function\nuint32 line",
  "rosapi_msgs/TypeDef":
    "string type\nstring[] fieldnames\nstring[] fieldtypes\nint32[] fieldarraylen\nstring[] examples\nstring[] constnames\nstring[] constvalues",
  "rosgraph_msgs/Clock": "builtin_interfaces/Time clock",
  "sensor_msgs/LaserScan":
    "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities",
  "sensor_msgs/Range":
    "uint8 ULTRASOUND=0\nuint8 INFRARED=1\nstd_msgs/Header header\nuint8 radiation_type\nfloat32 field_of_view\nfloat32 min_range\nfloat32 max_range\nfloat32 range\nfloat32 variance",
  "std_msgs/Bool": "bool data",
  "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id",
  "std_msgs/String": "string data",
  "tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms",
} as const satisfies Record<string, string>;
export type MessageType = keyof typeof messageTexts;

const details = (field: string): string =>
  [`string ${field}`, "---", "rosapi_msgs/TypeDef[] typedefs"].join("\n");

/** Request and response, by short name, without `/srv/`. */
export const serviceTexts = {
  "nav_msgs/GetMap": "---\nnav_msgs/OccupancyGrid map",
  "std_srvs/Trigger": "---\nbool success\nstring message",
  "rosapi_msgs/DeleteParam": "string name\n---",
  "rosapi_msgs/GetActionServers": "---\nstring[] action_servers",
  "rosapi_msgs/GetParam": "string name\nstring default_value\n---\nstring value",
  "rosapi_msgs/GetParamNames": "---\nstring[] names",
  "rosapi_msgs/GetROSVersion": "---\nuint8 version\nstring distro",
  "rosapi_msgs/GetTime": "---\nbuiltin_interfaces/Time time",
  "rosapi_msgs/HasParam": "string name\n---\nbool exists",
  "rosapi_msgs/Interfaces": "---\nstring[] interfaces",
  "rosapi_msgs/MessageDetails": details("type"),
  "rosapi_msgs/NodeDetails":
    "string node\n---\nstring[] subscribing\nstring[] publishing\nstring[] services",
  "rosapi_msgs/Nodes": "---\nstring[] nodes",
  "rosapi_msgs/Publishers": "string topic\n---\nstring[] publishers",
  "rosapi_msgs/ServiceNode": "string service\n---\nstring node",
  "rosapi_msgs/ServiceProviders": "string service\n---\nstring[] providers",
  "rosapi_msgs/ServiceRequestDetails": details("type"),
  "rosapi_msgs/ServiceResponseDetails": details("type"),
  "rosapi_msgs/ServiceType": "string service\n---\nstring type",
  "rosapi_msgs/Services": "---\nstring[] services",
  "rosapi_msgs/ServicesForType": "string type\n---\nstring[] services",
  "rosapi_msgs/SetParam": "string name\nstring value\n---",
  "rosapi_msgs/Subscribers": "string topic\n---\nstring[] subscribers",
  "rosapi_msgs/TopicType": "string topic\n---\nstring type",
  "rosapi_msgs/Topics": "---\nstring[] topics\nstring[] types",
  "rosapi_msgs/TopicsAndRawTypes":
    "---\nstring[] topics\nstring[] types\nstring[] typedefs_full_text",
  "rosapi_msgs/TopicsForType": "string type\n---\nstring[] topics",
} as const satisfies Record<string, string>;
export type ServiceType = keyof typeof serviceTexts;

const goalResult =
  "string state\nstring reason\nfloat64 distance\nfloat64 x\nfloat64 y\nfloat64 theta";
const goalFeedback = "float64 distance\nfloat64 x\nfloat64 y\nfloat64 theta";

/** Goal, result and feedback, by short name, without `/action/`. */
export const actionTexts = {
  "corridor_msgs/Do": `string action\n---\n${goalResult}\n---\n${goalFeedback}`,
  "corridor_msgs/Move": `float64 distance\n---\n${goalResult}\n---\n${goalFeedback}`,
  "corridor_msgs/Turn": `float64 angle\n---\n${goalResult}\n---\n${goalFeedback}`,
} as const satisfies Record<string, string>;
export type ActionType = keyof typeof actionTexts;
