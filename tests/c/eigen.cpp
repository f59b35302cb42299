// The maps for Eigen of an exported library: the numbers are those of the arrays.
#include <Eigen/Geometry>

#include "puma560.hpp"

#include <cstdio>

int main() {
    const puma560::Robot robot;
    const puma560::Joints q{0.1, -0.8, 0.6, 0.2, 0.9, -0.3};
    const puma560::Pose pose = robot.forward(q);
    const puma560::Jacobian jacobian = robot.jacobian(q);

    Eigen::Isometry3d frame;
    frame.matrix() = puma560::matrix(pose);
    // A small step along a direction in joint space moves the tool as the Jacobian says.
    const Eigen::Matrix<double, 6, 1> speeds = (Eigen::Matrix<double, 6, 1>() << 0.3, -0.2, 0.5, 0.1, -0.7, 0.4).finished();
    puma560::Joints moved;
    Eigen::Map<Eigen::Matrix<double, 6, 1>>(moved.data()) = puma560::vector(q) + 1e-6 * speeds;
    const Eigen::Vector3d step = (puma560::matrix(robot.forward(moved)).topRightCorner<3, 1>() - frame.translation()) / 1e-6;
    const Eigen::Vector3d said = (puma560::matrix(jacobian) * speeds).head<3>();
    if ((step - said).norm() > 1e-5 || puma560::pose_of(frame) != pose) {
        std::printf("Eigen: the numbers differ\n");
        return 1;
    }
    const auto solution = robot.inverse_near(puma560::pose_of(frame), q);
    if (!solution || std::abs(solution->q[0] - q[0]) > 1e-9) {
        std::printf("Eigen: no solution\n");
        return 1;
    }
    std::printf("Eigen: the maps agree\n");
    return 0;
}
