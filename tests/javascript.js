// Runs arms that the JavaScript backend printed: one JSON document in on standard input, one out.
let input = "";
process.stdin.on("data", (part) => { input += part; });
process.stdin.on("end", () => {
  const answers = JSON.parse(input).map(({ script, parameters, cases }) => {
    const [arm, tasks] = new Function(`${script}\nreturn [new Arm(), TASKS];`)();
    for (const name of Object.keys(arm.parameters)) arm.parameters[name] = parameters[name];
    return cases.map((q) => {
      const pose = arm.forward(q), answer = arm.inverse(tasks[arm.task].of(pose), arm.redundant.map((k) => q[k]));
      return { pose, frames: arm.frames(q), jacobian: arm.jacobian(q), ...answer };
    });
  });
  process.stdout.write(JSON.stringify(answers));
});
