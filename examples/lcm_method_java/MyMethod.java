import java.io.IOException;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMSubscriber;
import slalom.command_t;
import slalom.error_t;
import slalom.hello_t;
import slalom.observation_t;
import slalom.ready_t;
import slalom.run_start_t;

/**
 * An avoidance method as a separate process, in Java (Debian: default-jdk-headless, liblcm-java, liblcm-bin): turns to
 * the free direction closest to the goal. The generated messages are in types/ (see campaign.ini).
 */
public class MyMethod implements LCMSubscriber {
  private static final int PROTOCOL_VERSION = 1;

  private final String channel;
  private hello_t robot;
  private double lookAhead = 1.0; // m

  private MyMethod(LCM lcm, String channel) {
    this.channel = channel;
    lcm.subscribe(channel + "_HELLO", this);
    lcm.subscribe(channel + "_RUN_START", this);
    lcm.subscribe(channel + "_OBSERVATION", this);
  }

  @Override
  public void messageReceived(LCM lcm, String from, LCMDataInputStream data) {
    try {
      if (from.endsWith("_HELLO")) handleHello(lcm, new hello_t(data));
      if (from.endsWith("_RUN_START")) ready(lcm, new run_start_t(data).run_id); // a method with state clears it here
      if (from.endsWith("_OBSERVATION")) lcm.publish(channel + "_COMMAND", command(new observation_t(data)));
    } catch (IOException exception) {
      System.err.println(from + ": " + exception);
    }
  }

  private void handleHello(LCM lcm, hello_t hello) {
    if (hello.protocol_version != PROTOCOL_VERSION) {
      refuse(lcm, hello.id, "MyMethod requires another protocol version");
      return;
    }
    for (int i = 0; i < hello.setting_count; i++) {
      if (!hello.keys[i].equals("look_ahead")) {
        refuse(lcm, hello.id, "unknown setting; expected look_ahead");
        return;
      }
      lookAhead = Double.parseDouble(hello.values[i]);
    }
    robot = hello;
    ready(lcm, hello.id);
  }

  private command_t command(observation_t o) {
    double goal = Math.atan2(o.goal_y, o.goal_x);
    double desiredDistance = Math.min(lookAhead, Math.hypot(o.goal_x, o.goal_y));
    command_t command = new command_t();
    command.run_id = o.run_id;
    command.sequence = o.sequence;
    command.w = robot.max_w / 2; // no free direction: rotate
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < o.rays; i += 4) {
      double direction = angle(i);
      if (Math.abs(direction - goal) >= best || freeDistance(o.ranges, direction) < desiredDistance) continue;
      best = Math.abs(direction - goal);
      command.w = clamp(2 * direction, -robot.max_w, robot.max_w);
      command.v = clamp(freeDistance(o.ranges, 0) - 0.1, 0, robot.max_v) * Math.max(0, Math.cos(direction));
    }
    return command;
  }

  private double angle(int ray) {
    return robot.aperture * (ray / (robot.rays - 1.0) - 0.5);
  }

  /** Free distance of the robot straight in a direction, m. */
  private double freeDistance(float[] ranges, double direction) {
    double free = robot.max_range;
    for (int i = 0; i < ranges.length; i++) {
      double angle = angle(i) - direction;
      if (Math.cos(angle) > 0 && Math.abs(ranges[i] * Math.sin(angle)) < robot.radius + 0.1)
        free = Math.min(free, ranges[i] * Math.cos(angle) - robot.radius);
    }
    return free;
  }

  private static double clamp(double value, double low, double high) {
    return Math.max(low, Math.min(high, value));
  }

  private void ready(LCM lcm, long id) {
    ready_t answer = new ready_t();
    answer.protocol_version = PROTOCOL_VERSION;
    answer.id = id;
    answer.name = "MyMethod";
    lcm.publish(channel + "_READY", answer);
  }

  private void refuse(LCM lcm, long id, String reason) {
    error_t error = new error_t();
    error.id = id;
    error.text = reason;
    lcm.publish(channel + "_ERROR", error);
  }

  private static String environmentVariable(String name, String defaultValue) {
    String value = System.getenv(name);
    return value == null ? defaultValue : value;
  }

  public static void main(String[] arguments) throws Exception {
    LCM lcm = new LCM(environmentVariable("SLALOM_LCM_URL", "udpm://239.255.76.67:7667?ttl=0"));
    new MyMethod(lcm, environmentVariable("SLALOM_LCM_CHANNEL", "SLALOM"));
    Thread.currentThread().join(); // LCM's thread receives; the process is killed at the end
  }
}
