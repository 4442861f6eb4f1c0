/** The four range sensors, clockwise from the front; the order of every list of readings. */
export const sensorNames = ["front", "right", "back", "left"] as const;
export type SensorName = (typeof sensorNames)[number];
